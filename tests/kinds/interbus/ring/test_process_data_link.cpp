// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/support/process_data_link_contract.h"
#include "tests/support/scripted_link.h"

namespace codewheel {
namespace {

LinkUnderTest quick()
{
    return {"quick", [] { return std::make_unique<ScriptedLink>(2); }};
}

LinkUnderTest slow()
{
    return {"slow", [] {
                auto link = std::make_unique<ScriptedLink>(2);
                link->delay(std::chrono::milliseconds(2));
                return link;
            }};
}

LinkUnderTest failing(int n)
{
    return {"failing",
            [n] {
                auto link = std::make_unique<ScriptedLink>(2);
                link->failAt(n);
                return link;
            },
            1};
}

INSTANTIATE_TEST_SUITE_P(ScriptedLink, ProcessDataLinkContract,
                         testing::Values(quick(), slow(), failing(1), failing(2), failing(3)));

LinkUnderTest trainingBus()
{
    return {.name = "training bus",
            .make = [] { return std::move(makeTrainingBus(Catalog::builtIn()).link); },
            .neverBlocks = true};
}

INSTANTIATE_TEST_SUITE_P(TrainingBus, ProcessDataLinkContract, testing::Values(trainingBus()));

} // namespace
} // namespace codewheel
