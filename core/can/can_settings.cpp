// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_settings.h"

#include "can/slcan_codec.h"
#include "vocabulary/enumeration_rows.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

// The translation context of these texts.
struct CanSettingText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanSettings)
};

constexpr auto canSettingRows = std::to_array<CanSetting>({
    {.key = canRateKey,
     .its = &CanLinkArgument::rate,
     .least = slcanRates.front(),
     .most = slcanRates.back(),
     .usual = 125'000,
     .ofAdapters = slcanRates,
     .wrong = CanRefusalId::rateWrong,
     .labelOfForm = QT_TRANSLATE_NOOP("codewheel::CanSettings", "R&ate of the bus"),
     .sentenceOfForm = QT_TRANSLATE_NOOP(
         "codewheel::CanSettings", "The same for all nodes of the bus; a node at another rate disturbs it")},
    {.key = canBaudKey,
     .its = &CanLinkArgument::baudRate,
     .least = 1,
     .most = 12'000'000,
     .usual = CanLinkArgument::usualBaudRate,
     .ofAdapters = {},
     .wrong = CanRefusalId::baudRateWrong,
     .labelOfForm = QT_TRANSLATE_NOOP("codewheel::CanSettings", "Ba&ud rate of the port"),
     .sentenceOfForm = QT_TRANSLATE_NOOP(
         "codewheel::CanSettings",
         "Between this computer and the adapter. Adapters that are USB devices themselves take any")},
});

} // namespace

bool CanSetting::hasAdapter(int value) const
{
    return isWithin(value) &&
           (ofAdapters.empty() || std::ranges::find(ofAdapters, value) != ofAdapters.end());
}

QString CanSetting::label() const
{
    return CanSettingText::tr(labelOfForm);
}

QString CanSetting::sentence() const
{
    return CanSettingText::tr(sentenceOfForm);
}

std::span<const CanSetting> canSettings()
{
    return canSettingRows;
}

const CanSetting *canSetting(QStringView key)
{
    return rowByKey(canSettingRows, key);
}

} // namespace codewheel
