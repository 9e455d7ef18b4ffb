// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/mode_text.h"

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {
namespace {

constexpr auto modeRows = std::to_array<KeyedText<Mode>>({
    {Mode::position, "position", QT_TRANSLATE_NOOP("Mode", "position mode")},
    {Mode::velocity, "velocity", QT_TRANSLATE_NOOP("Mode", "velocity mode")},
    {Mode::cam, "cam", QT_TRANSLATE_NOOP("Mode", "cam mode")},
});
static_assert(areInOrder(modeRows, &KeyedText<Mode>::id));

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
                      : QCoreApplication::translate("Mode", rowOf(modeRows, mode).text);
}

std::vector<RefusalArgument> modeArguments(const SwitchMode &mode)
{
    return modeArguments(mode.mode, programOf(mode));
}

std::vector<RefusalArgument> modeArguments(Mode mode, std::optional<unsigned> camProgram)
{
    std::vector<RefusalArgument> arguments{QString::fromLatin1(rowOf(modeRows, mode).key)};
    if (camProgram)
        arguments.emplace_back(std::int64_t{*camProgram});
    return arguments;
}

QString modeText(const std::vector<RefusalArgument> &arguments)
{
    const QStringList parts = argumentTexts(arguments);
    const auto *row = rowByKey(modeRows, parts.value(0));
    if (row == nullptr)
        return parts.value(0);
    const auto *program = arguments.size() > 1 ? std::get_if<std::int64_t>(&arguments[1]) : nullptr;
    return modeText(row->id,
                    program != nullptr ? std::optional(static_cast<unsigned>(*program)) : std::nullopt);
}

} // namespace codewheel
