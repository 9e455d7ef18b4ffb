// SPDX-License-Identifier: GPL-3.0-or-later
#include "finder/spoken_protocol.h"
#include "kinds/buses.h"

#include <algorithm>

namespace codewheel {
namespace {

std::vector<std::unique_ptr<const SpokenProtocol>> &protocols()
{
    static auto all = builtInSpokenProtocols();
    return all;
}

} // namespace

std::vector<const SpokenProtocol *> spokenProtocols()
{
    std::vector<const SpokenProtocol *> all;
    for (const auto &one : protocols())
        all.push_back(one.get());
    return all;
}

std::vector<const SpokenProtocol *> spokenProtocolsAt(const QString &port)
{
    std::vector<const SpokenProtocol *> all = spokenProtocols();
    std::erase_if(all, [&](const auto *one) { return one->fitsAt(port) == SpokenProtocol::Fit::none; });
    std::stable_partition(all.begin(), all.end(),
                          [&](const auto *one) { return one->fitsAt(port) == SpokenProtocol::Fit::first; });
    return all;
}

void addSpokenProtocol(std::unique_ptr<const SpokenProtocol> protocol)
{
    protocols().push_back(std::move(protocol));
}

} // namespace codewheel
