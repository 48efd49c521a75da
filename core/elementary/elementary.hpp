#pragma once

/// Elementary functions with the same result, to the last bit, on every machine. Those of the standard
/// library differ from library to library, and glibc's from processor to processor: where a motion is
/// chaotic, a last bit decides what it looks like after ten seconds.
///
/// Here are additions, multiplications, divisions and square roots alone, which IEEE 754 rounds in one way,
/// and work on bits. Errors are at most 0.52 units in the last place, so nearly every result is the right one
/// rounded (tests/core/elementary_test.cpp). Special values are those of the C standard, annex F; `errno` and
/// the floating-point exceptions mean nothing.
///
/// std::fmod, remainder, floor, ceil, round, sqrt and the like are exact or rightly rounded everywhere, and
/// used as they are.
namespace jw::elementary {

double sin(double angle);
double cos(double angle);
double tan(double angle);

/// Sine and cosine of one angle, at little more than the price of one of them.
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
