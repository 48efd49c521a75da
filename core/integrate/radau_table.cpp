#include <array>

#include "core/integrate/radau.hpp"

namespace jw {

namespace {

template <std::size_t S>
struct Coefficients {
    std::array<double, S> c;
    std::array<double, S * S> a;  ///< row by row
    double gamma_0;
    std::array<double, S> e;
};

// The nodes c are the zeros of P_s - P_(s-1), shifted to (0, 1]; a integrates polynomials of degree below s
// exactly from 0 to c_i. With b, the last row of a, and b_hat, the quadrature of order s whose weight at 0 is
// gamma_0: a^T e = b_hat - b. Solved in double precision. The last digits are kept because numbers of lessons
// depend on them, although (3, 3) of the first table is 1/9 to 16 digits only.

constexpr Coefficients<3> kOrder5{
    {0.15505102572168217, 0.64494897427831788, 1.0},
    {0.19681547722366038, -0.065535425850198351, 0.023770974348220144,  //
     0.39442431473908729, 0.29207341166522854, -0.041548752125997956,   //
     0.37640306270046731, 0.51248582618842176, 0.11111111111111099},
    0.2748888295956774,
    {-2.7623054547485988, 0.37993559825272871, -0.091629609865225753}};

constexpr Coefficients<5> kOrder9{
    {0.057104196114517669, 0.2768430136381238, 0.58359043236891683, 0.86024013565621948, 1.0},
    {0.072998864317903311,  -0.026735331107945577,  0.018676929763984381,
     -0.012879106093306477, 0.005042839233882033,  //
     0.15377523147918251,   0.14621486784749341,    -0.036444568905128025,
     0.021233063119304691,  -0.0079355799027287718,  //
     0.14006304568481004,   0.29896712949128307,    0.16758507013524945,
     -0.033969101686618132, 0.010944288744192411,  //
     0.1448943081095333,    0.27650006876016253,    0.3257979229104172,
     0.12875675325491315,   -0.015708917378806777,  //
     0.14371356079122599,   0.2813560151494619,     0.31182652297574148,
     0.22310390108357056,   0.040000000000000029},
    0.15906584442746724,
    {-4.4189977167963761, 0.57923485225668958, -0.19923756095348236, 0.094167483691954518,
     -0.031813168885497095}};

template <std::size_t S>
RadauTable table_of(const Coefficients<S>& known) {
    constexpr auto s = static_cast<Eigen::Index>(S);
    return {
        Eigen::Map<const VectorX>(known.c.data(), s),
        Eigen::Map<const MatrixX>(known.a.data(), s, s).transpose(), known.gamma_0,
        Eigen::Map<const VectorX>(known.e.data(), s)};
}

}  // namespace

RadauTable radau_table(int stages) { return stages == 3 ? table_of(kOrder5) : table_of(kOrder9); }

}  // namespace jw
