// SPDX-License-Identifier: GPL-3.0-or-later
#include "finder/line_protocol.h"

#include "finder/esc_on_line.h"
#include "finder/rtu_on_line.h"

namespace codewheel {
namespace {

std::vector<std::unique_ptr<const LineProtocol>> &protocols()
{
    static std::vector<std::unique_ptr<const LineProtocol>> all = [] {
        std::vector<std::unique_ptr<const LineProtocol>> builtIn;
        builtIn.push_back(makeEscOnLine());
        builtIn.push_back(makeRtuOnLine());
        return builtIn;
    }();
    return all;
}

} // namespace

std::vector<const LineProtocol *> lineProtocols()
{
    std::vector<const LineProtocol *> all;
    for (const auto &one : protocols())
        all.push_back(one.get());
    return all;
}

void addLineProtocol(std::unique_ptr<const LineProtocol> protocol)
{
    protocols().push_back(std::move(protocol));
}

} // namespace codewheel
