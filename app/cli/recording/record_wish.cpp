// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/recording/record_wish.h"

#include "cli/call/texts.h"
#include "recording/server_address.h"

#include <QDateTime>
#include <QFileInfo>
#include <QTimeZone>

#include <array>
#include <limits>

namespace codewheel {
namespace {

constexpr int longestRecording = 366 * 24 * 3'600; // s
constexpr int longestBefore = 3'600;               // s, of what is kept in memory
constexpr int longestKept = 366 * 24;              // h
constexpr std::int64_t bytesOfMegabyte = 1'000'000;

constexpr std::array countedFromTrigger{"--before", "--after"};

Checked<void> checkCombination(const Arguments &arguments)
{
    if (arguments.has("--for") && arguments.has("--trigger"))
        return badInput("badOption",
                        CommandLine::tr("Give --for or --trigger, not both. How long to record after the "
                                        "trigger is told by --after."));
    for (const char *option : countedFromTrigger)
        if (arguments.has(option) && !arguments.has("--trigger"))
            return badInput(
                "badOption",
                CommandLine::tr("%1 counts from a trigger: give --trigger too. Without one, --for "
                                "tells how long to record."),
                {QString::fromLatin1(option)});
    if (arguments.has("--device") && arguments.rest.isEmpty())
        return badInput("missingPlace",
                        CommandLine::tr("--device tells what the encoder at a PLACE is. Name the PLACE."));
    return {};
}

// Whether there is such a server is only known once it is asked.
Checked<QString> serverMeant(const Arguments &arguments)
{
    if (arguments.has("-o"))
        return badInput(
            "badOption",
            CommandLine::tr("Give -o or --to, not both: a recording is in a file or on a server."));
    const auto address = ServerAddress::parse(*arguments.value("--to"));
    if (!address)
        return tl::unexpected(complaintAbout(address.error()));
    return address->text();
}

Checked<QString> fileToMake(const Arguments &arguments)
{
    const auto file = arguments.value("-o");
    if (!file || file->isEmpty())
        return badInput("missingFile",
                        CommandLine::tr("Name the file of the recording: -o FILE, usually with a name that "
                                        "ends in .cwrec; or the server, --to ADDRESS."));
    const QFileInfo info(*file);
    if (info.exists() || info.isSymLink()) // before anything is asked on a bus
        return tl::unexpected(complaintAbout({RefusalKind::badInput, RefusalId::recordingExists, {*file}}));
    return *file;
}

// A number that may be missing.
class OptionalNumber
{
public:
    OptionalNumber(const Arguments &arguments, std::optional<Complaint> &wrong)
        : m_arguments(arguments)
        , m_wrong(wrong)
    {}

    std::optional<int> operator()(const char *option, int minimum, int maximum) const
    {
        if (!m_arguments.has(option))
            return std::nullopt;
        const auto number = m_arguments.number(option, minimum, minimum, maximum);
        if (!number && !m_wrong)
            m_wrong = number.error();
        return number ? std::optional(*number) : std::nullopt;
    }

private:
    const Arguments &m_arguments;
    std::optional<Complaint> &m_wrong;
};

} // namespace

QString RecordWish::target() const
{
    return isOnServer() ? plan.settings.server : plan.settings.file;
}

Checked<RecordWish> RecordWish::of(const Arguments &arguments)
{
    using std::chrono::seconds;
    if (const auto checked = checkCombination(arguments); !checked)
        return tl::unexpected(checked.error());
    const bool isOnServer = arguments.has("--to");
    const auto target = isOnServer ? serverMeant(arguments) : fileToMake(arguments);
    if (!target)
        return tl::unexpected(target.error());
    RecordWish wish;
    RecordingSettings &settings = wish.plan.settings;
    (isOnServer ? settings.server : settings.file) = *target;
    settings.program = QStringLiteral("Codewheel " CODEWHEEL_VERSION);
    settings.zone = QString::fromLatin1(QTimeZone::systemTimeZoneId());
    wish.plan.withTraffic = !arguments.has("--no-traffic");
    std::optional<Complaint> wrong;
    const OptionalNumber number(arguments, wrong);
    if (const auto given = number("--for", 1, longestRecording))
        wish.plan.extent.after = wish.duration = seconds(*given);
    if (const auto given = number("--before", 0, longestBefore))
        wish.plan.extent.before = seconds(*given);
    if (const auto given = number("--after", 0, longestRecording))
        wish.plan.extent.after = seconds(*given);
    if (const auto given = number("--last", 1, longestKept))
        settings.keptFor = std::chrono::hours(*given);
    if (const auto given = number("--max-size", 1, std::numeric_limits<int>::max()))
        settings.largestSize = *given * bytesOfMegabyte;
    if (const auto given = number("--keep-free", 0, std::numeric_limits<int>::max()))
        settings.leastFree = *given * bytesOfMegabyte;
    if (wrong)
        return tl::unexpected(*wrong);
    return wish;
}

} // namespace codewheel
