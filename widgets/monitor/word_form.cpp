// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/word_form.h"

#include "catalog/device_description.h"
#include "kinds/interbus/words/k3_word.h"

namespace codewheel {

namespace {

// Status D31..D29 | parameter number D28..D25 | data D24..D0 by nibbles.
constexpr WordForm k3Form{.bits = 32,
                          .groupStarts = 1U << 29 | 1U << 25 | (WordForm::nibbles & 0x01FF'FFFF),
                          .dataBits = k3::dataBits,
                          .commandBits = k3::controlMask};

// Service, read or write, error, 0: D31..D28 | service number D27..D24 | data D23..D0 by nibbles. Nothing
// happens until the service bit is set.
constexpr WordForm la66Form{
    .bits = 32, .groupStarts = WordForm::nibbles, .dataBits = 24, .commandBits = 1U << 31};

} // namespace

WordForm wordForm(int bits, const DeviceDescription *device)
{
    if (bits == 16)
        return {.bits = 16, .dataBits = 16};
    if (device == nullptr)
        return {};
    if (device->profile == Profile::k3)
        return k3Form;
    return device->profile == Profile::la66 ? la66Form : WordForm();
}

} // namespace codewheel
