// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/word_form.h"

#include "catalog/protocol_rules.h"
#include "catalog/word_meanings.h"

namespace codewheel {

WordForm wordForm(int bits, const DeviceDescription *device)
{
    if (bits == 16)
        return {.bits = 16, .dataBits = 16};
    const WordMeanings *meanings =
        device != nullptr ? protocolRules(device->profile).wordMeanings() : nullptr;
    return meanings != nullptr ? meanings->form() : WordForm();
}

} // namespace codewheel
