// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "jobs/job_check.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

struct WideRange
{
    QStringView device;
    Parameter parameter;
    std::int64_t largest; // that fits the data field
};

// A range that slipped past the catalog: what does not fit the field would be cut off silently.
TEST(JobCheck, RefusesWhatTheDataFieldCannotHoldWhateverTheDescriptionSays)
{
    const Catalog catalog = Catalog::builtIn();
    for (const WideRange &row : {WideRange{u"fraba-ocd-ib", Parameter::steps, 33'554'431},
                                 WideRange{u"tr-la66", Parameter::measuringLength, 16'777'215}}) {
        DeviceDescription device = *catalog.find(row.device);
        for (ParameterDescription &each : device.parameters) {
            each.minimum = -1;
            each.maximum = 1'099'511'627'776;
        }
        EXPECT_TRUE(checkValue(device, {row.parameter, row.largest}));
        for (const std::int64_t value :
             {std::int64_t{-1}, row.largest + 1, std::int64_t{1'099'511'627'776}}) {
            const Result<void> checked = checkValue(device, {row.parameter, value});
            ASSERT_FALSE(checked) << value;
            EXPECT_EQ(checked.error(), (Refusal{RefusalKind::badInput,
                                                RefusalId::valueOutOfRange,
                                                {row.parameter, value, std::int64_t{0}, row.largest}}));
        }
    }
}

// As a project file may have it.
TEST(JobCheck, RefusesATextWhereTheParameterIsANumber)
{
    const Catalog catalog = Catalog::builtIn();
    for (const QStringView key : {u"fraba-ocd-ib", u"kuebler-esc-rs485"}) {
        const DeviceDescription *device = catalog.find(key);
        ASSERT_NE(device, nullptr) << key.toString().toStdString();
        const auto checked = checkValue(*device, {Parameter::steps, Value(QStringLiteral("255"))});
        ASSERT_FALSE(checked) << key.toString().toStdString();
        EXPECT_EQ(checked.error().id, RefusalId::valueNotAllowed);
    }
}

} // namespace
} // namespace codewheel
