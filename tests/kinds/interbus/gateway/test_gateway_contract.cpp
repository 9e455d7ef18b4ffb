// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/interbus/gateway/gateway_ring.h"
#include "tests/support/process_data_link_contract.h"

namespace codewheel {
namespace {

using namespace test;

LinkUnderTest gateway(const char *name, const GatewaySettings &settings)
{
    return {name, [settings] {
                return std::make_unique<GatewayLink>(
                    std::make_unique<RegisterBankPort>(std::make_shared<RegisterBank>()), settings,
                    k3Ring(70));
            }};
}

INSTANTIATE_TEST_SUITE_P(
    Gateway, ProcessDataLinkContract,
    testing::Values(gateway("usual", {}), gateway("low word first", {.highWordFirst = false}),
                    gateway("function 23",
                            {.inArea = RegisterArea::holding, .inFirst = 1'000, .writesWithRead = true})));

} // namespace
} // namespace codewheel
