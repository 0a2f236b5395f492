// Numbers with the digits that people need. Machines get all digits from json() and csv().
#pragma once

#include <string>
#include <vector>

namespace gsbench::render {

// `significant` digits without trailing zeros; "–" for NaN.
std::string figure(double value, int significant = 5);

// `decimals` digits after the point, 0 … 9; "–" for NaN; never "-0.00".
std::string fixed(double value, int decimals);

// Digits after the point for values of one quantity, the same for all of them:
//   with an uncertainty, the last digit is worth about as much as the uncertainty (0.0625 ms: 1);
//   without one, 0 if all values are whole numbers, otherwise 4 significant digits of the largest
//   magnitude, 3 if that is below 10 and 2 if it is below 1.
// Values that are not finite do not count.
int decimals_for(const std::vector<double>& values, double uncertainty = 0.0);

// Digits after the point that show two significant digits of `value`, at least 0.
int decimals_of_two_digits(double value);

// Digits after the point of `value` as it is written with up to six significant digits. For steps
// and for published figures; a computed figure beside a published one has one digit more.
int decimals_of_written(double value);

}  // namespace gsbench::render
