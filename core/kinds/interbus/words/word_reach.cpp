// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/word_reach.h"

#include <algorithm>

namespace codewheel {
namespace {

const ParameterDescription *parameterBy(const DeviceDescription &device, std::optional<unsigned> code,
                                        std::optional<unsigned> WordReach::*member)
{
    const auto found = std::ranges::find(device.parameters, code, [member](const ParameterDescription &its) {
        return wordReach(its).*member;
    });
    return found == device.parameters.end() ? nullptr : &*found;
}

} // namespace

WordReach wordReach(const ParameterDescription &parameter)
{
    const auto *reach = parameter.reach.as<WordReach>();
    return reach != nullptr ? *reach : WordReach();
}

const ParameterDescription *findNumber(const DeviceDescription &device, unsigned number)
{
    return parameterBy(device, number, &WordReach::number);
}

const ParameterDescription *findReadOut(const DeviceDescription &device, unsigned code)
{
    return parameterBy(device, code, &WordReach::readOut);
}

} // namespace codewheel
