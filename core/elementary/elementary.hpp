#pragma once

/// Elementary functions with the same result, to the last bit, on every machine. Those of the standard
/// library differ between libraries, and glibc's also between processors: if a motion is chaotic, a last bit
/// decides what it looks like after ten seconds.
///
/// They use only additions, multiplications, divisions and square roots, which IEEE 754 rounds in one way,
/// and operations on bits. Errors are at most 0.52 units in the last place, so nearly every result is
/// correctly rounded (tests/core/elementary_test.cpp). Special values are those of the C standard, annex F;
/// `errno` and the floating-point exceptions have no meaning.
///
/// std::fmod, remainder, floor, ceil, round, sqrt and the like are exact or correctly rounded everywhere, so
/// they are used directly.
namespace jw::elementary {

double sin(double angle);
double cos(double angle);
double tan(double angle);

/// Sine and cosine of one angle, in little more time than one of them takes.
struct SineAndCosine {
    double sine;
    double cosine;
};
SineAndCosine sine_and_cosine(double angle);

double asin(double x);
double acos(double x);
double atan(double x);
double atan2(double y, double x);

double exp(double x);
double log(double x);
double log10(double x);
double pow(double x, double y);

double hypot(double x, double y);

}  // namespace jw::elementary
