// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/mode_text.h"

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

struct ModeRow
{
    Mode mode;
    const char *key;
    const char *text;
};
constexpr std::array modeRows{
    ModeRow{Mode::position, "position", QT_TRANSLATE_NOOP("Mode", "position mode")},
    ModeRow{Mode::velocity, "velocity", QT_TRANSLATE_NOOP("Mode", "velocity mode")},
    ModeRow{Mode::cam, "cam", QT_TRANSLATE_NOOP("Mode", "cam mode")},
};
static_assert(areInOrder(modeRows, &ModeRow::mode));

const ModeRow &modeRow(Mode mode)
{
    return modeRows.at(static_cast<std::size_t>(mode));
}

std::optional<unsigned> programOf(const SwitchMode &mode)
{
    return mode.mode == Mode::cam ? std::optional(mode.camProgram) : std::nullopt;
}

} // namespace

QString modeText(const SwitchMode &mode)
{
    return modeText(mode.mode, programOf(mode));
}

QString modeText(Mode mode, std::optional<unsigned> camProgram)
{
    return camProgram ? sentence(QCoreApplication::translate("Mode", "cam mode, program %1"),
                                 {QString::number(*camProgram)})
                      : QCoreApplication::translate("Mode", modeRow(mode).text);
}

std::vector<RefusalArgument> modeArguments(const SwitchMode &mode)
{
    return modeArguments(mode.mode, programOf(mode));
}

std::vector<RefusalArgument> modeArguments(Mode mode, std::optional<unsigned> camProgram)
{
    std::vector<RefusalArgument> arguments{QString::fromLatin1(modeRow(mode).key)};
    if (camProgram)
        arguments.emplace_back(std::int64_t{*camProgram});
    return arguments;
}

QString modeText(const std::vector<RefusalArgument> &arguments)
{
    const QStringList parts = argumentTexts(arguments);
    const auto row = std::ranges::find_if(
        modeRows, [&](const ModeRow &one) { return parts.value(0) == QLatin1String(one.key); });
    if (row == modeRows.end())
        return parts.value(0);
    const auto *program = arguments.size() > 1 ? std::get_if<std::int64_t>(&arguments[1]) : nullptr;
    return modeText(row->mode,
                    program != nullptr ? std::optional(static_cast<unsigned>(*program)) : std::nullopt);
}

} // namespace codewheel
