// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/sdo_dialogues.h"

#include "kinds/canopen/protocol/canopen_explain.h"
#include "kinds/canopen/protocol/sdo_abort.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace codewheel::canopen {
namespace {

using Kind = SdoFrame::Kind;

struct DialogueTexts
{
    Q_DECLARE_TR_FUNCTIONS(SdoDialogue)
};

bool isText(Octets value)
{
    return std::ranges::all_of(value, [](std::uint8_t octet) { return octet >= 0x20 && octet < 0x7F; });
}

// A number as a device tells it, a text, or octets.
QString valueText(Octets value)
{
    constexpr std::size_t mostOfANumber = 4;
    if (!value.empty() && value.size() <= mostOfANumber) {
        const std::uint32_t number = numberOf(value);
        return sentence(QStringLiteral("%1 = %2"), {hexNumber(number), numberText(number)});
    }
    const QByteArray octets(reinterpret_cast<const char *>(value.data()),
                            static_cast<qsizetype>(value.size()));
    return isText(value) ? sentence(QStringLiteral("\"%1\""), {QString::fromLatin1(octets)})
                         : QString::fromLatin1(octets.toHex(' ').toUpper());
}

QString endText(const SdoDialogue &told)
{
    const QString begun = sentence(
        told.isWrite ? DialogueTexts::tr("write %1") : DialogueTexts::tr("read %1"), {told.object.text()});
    const bool hasValue = told.end == SdoDialogue::End::answered || told.isWrite;
    const QString what =
        hasValue ? sentence(QStringLiteral("%1 = %2"), {begun, valueText(told.value)}) : begun;
    if (told.end == SdoDialogue::End::answered)
        return what;
    if (told.end == SdoDialogue::End::unanswered)
        return sentence(DialogueTexts::tr("%1, not answered"), {what});
    const QString code = hexNumber(told.abortCode, 8);
    const QString reason = sdoAbortText(told.abortCode);
    const QString abort = reason.isEmpty() ? code : sentence(QStringLiteral("%1: %2"), {code, reason});
    return sentence(told.isAbortedByClient ? DialogueTexts::tr("%1, broken off by whoever asked, %2")
                                           : DialogueTexts::tr("%1, refused, %2"),
                    {what, abort});
}

} // namespace

QString SdoDialogue::text() const
{
    const QString told = sentence(DialogueTexts::tr("Node %1: %2"), {QString::number(node), endText(*this)});
    if (end == End::unanswered)
        return told;
    const double milliseconds = std::chrono::duration<double, std::milli>(ended - begun).count();
    return sentence(DialogueTexts::tr("%1 (%2 ms)"), {told, QLocale().toString(milliseconds, 'f', 1)});
}

SdoDialogues::Taken SdoDialogues::take(const CanFrame &frame, Instant at)
{
    const auto cob = frame.isExtended || frame.isError || frame.isRemote ? std::nullopt : CobId::of(frame.id);
    const bool isAnswer = cob && cob->service == CobId::Service::sdoAnswer;
    if (!isAnswer && (!cob || cob->service != CobId::Service::sdoRequest))
        return {};
    const auto sdo = isAnswer ? SdoFrame::answer(frame.data()) : SdoFrame::request(frame.data());
    if (!sdo)
        return {};
    Open &open = m_open.at(static_cast<std::size_t>(cob->node));
    open.dialogue.node = cob->node;
    return isAnswer ? answer(open, *sdo, at) : request(open, *sdo, at);
}

SdoDialogue SdoDialogues::close(Open &open, SdoDialogue::End end, Instant at)
{
    SdoDialogue ended = std::move(open.dialogue);
    ended.end = end;
    ended.ended = at;
    open = {};
    return ended;
}

SdoDialogues::Taken SdoDialogues::request(Open &open, const SdoFrame &sdo, Instant at)
{
    Taken taken{.isPart = open.isUnderWay};
    const bool begins = sdo.kind == Kind::read || sdo.kind == Kind::write || sdo.kind == Kind::writeBegins;
    const bool isOther = begins || sdo.kind == Kind::block || sdo.kind == Kind::unknown;
    const int node = open.dialogue.node;
    if (isOther && open.isUnderWay)
        taken.ended.push_back(close(open, SdoDialogue::End::unanswered, at));
    if (begins)
        open = {
            .isUnderWay = true,
            .isInSegments = sdo.kind == Kind::writeBegins,
            .dialogue = {.node = node, .object = sdo.object, .isWrite = sdo.kind != Kind::read, .begun = at}};
    if (isOther)
        taken.isPart = begins;
    if (!open.isUnderWay)
        return taken;
    SdoDialogue &its = open.dialogue;
    ++its.frames;
    if (its.isWrite)
        its.value.insert(its.value.end(), sdo.data().begin(), sdo.data().end());
    open.hasLastSegment |= sdo.kind == Kind::segment && sdo.isLast;
    if (sdo.kind == Kind::abort) {
        its.abortCode = sdo.abortCode;
        its.isAbortedByClient = true;
        taken.ended.push_back(close(open, SdoDialogue::End::aborted, at));
    }
    return taken;
}

SdoDialogues::Taken SdoDialogues::answer(Open &open, const SdoFrame &sdo, Instant at)
{
    SdoDialogue &its = open.dialogue;
    const bool namesAnother = (sdo.kind == Kind::value || sdo.kind == Kind::valueBegins ||
                               sdo.kind == Kind::written || sdo.kind == Kind::abort) &&
                              sdo.object != its.object;
    if (!open.isUnderWay || namesAnother || sdo.kind == Kind::block || sdo.kind == Kind::unknown)
        return {};
    Taken taken{.isPart = true};
    ++its.frames;
    if (!its.isWrite)
        its.value.insert(its.value.end(), sdo.data().begin(), sdo.data().end());
    if (sdo.kind == Kind::abort) {
        its.abortCode = sdo.abortCode;
        taken.ended.push_back(close(open, SdoDialogue::End::aborted, at));
    } else if (endsWith(open, sdo)) {
        taken.ended.push_back(close(open, SdoDialogue::End::answered, at));
    }
    return taken;
}

bool SdoDialogues::endsWith(Open &open, const SdoFrame &answer)
{
    if (!open.dialogue.isWrite)
        return answer.kind == Kind::value || (answer.kind == Kind::segment && answer.isLast);
    return open.isInSegments ? answer.kind == Kind::segmentWritten && open.hasLastSegment
                             : answer.kind == Kind::written;
}

std::vector<SdoDialogue> SdoDialogues::overdue(Instant now)
{
    std::vector<SdoDialogue> ended;
    for (Open &open : m_open)
        if (open.isUnderWay && now - open.dialogue.begun > patience)
            ended.push_back(close(open, SdoDialogue::End::unanswered, open.dialogue.begun));
    return ended;
}

} // namespace codewheel::canopen
