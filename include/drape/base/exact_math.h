#pragma once

namespace drape {

/// The functions below give the same bits on every processor and with every C library. Those of the C library do not:
/// the standard leaves their last bit open, and glibc takes another variant where a processor has fused multiply-add.
/// These consist of + - * / alone, whose bits IEEE 754 fixes, and of steps that are exact. Whatever decides a state, a
/// report or a table calls these; a test searches the sources for any other.
///
/// Each is the Taylor series about the nearest point where the value is known. Errors are in units in the last place of
/// the result (ulp).

/// sin(x), to 1 ulp for |x| <= 1e7. Beyond, the error stays below what the rounding of x itself makes.
/// @param x [rad]
double sine(double x);

/// The natural logarithm, to 1 ulp; of 0 it is -infinity, of less not a number.
double natural_log(double x);

/// e^x, to 1 ulp where the result is a normal number.
double exponential(double x);

/// e^x - 1 without the cancellation at small x, to 3 ulp.
double exponential_less_one(double x);

}  // namespace drape
