// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/canopen_explain.h"
#include "kinds/canopen/protocol/sdo_abort.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

namespace codewheel::canopen {
namespace {

class SdoTexts
{
    Q_DECLARE_TR_FUNCTIONS(CanopenSdo)

public:
    static QString value(const SdoFrame &sdo);
    static QString segments(const SdoFrame &sdo);
    static QString segment(const SdoFrame &sdo);
    static QString abort(const SdoFrame &sdo);
    static QString of(const SdoFrame &sdo);
};

QString SdoTexts::value(const SdoFrame &sdo)
{
    const std::uint32_t number = numberOf(sdo.data());
    const QStringList parts{sdo.object.text(), hexNumber(number), numberText(number)};
    return sdo.kind == SdoFrame::Kind::write ? sentence(tr("write %1 = %2 = %3"), parts)
                                             : sentence(QStringLiteral("%1 = %2 = %3"), parts);
}

QString SdoTexts::segments(const SdoFrame &sdo)
{
    const bool isWrite = sdo.kind == SdoFrame::Kind::writeBegins;
    const QString object = sdo.object.text();
    if (!sdo.wholeSize)
        return sentence(isWrite ? tr("write %1 in segments") : tr("%1 follows in segments"), {object});
    return sentence(isWrite ? tr("write %1 in segments, %2 bytes in all")
                            : tr("%1 follows in segments, %2 bytes in all"),
                    {object, numberText(*sdo.wholeSize)});
}

QString SdoTexts::segment(const SdoFrame &sdo)
{
    return sentence(sdo.isLast ? tr("last segment (bytes: %1)") : tr("segment (bytes: %1)"),
                    {QString::number(sdo.size)});
}

QString SdoTexts::abort(const SdoFrame &sdo)
{
    const QStringList parts{sdo.object.text(), hexNumber(sdo.abortCode, 8), sdoAbortText(sdo.abortCode)};
    return parts.last().isEmpty() ? sentence(tr("%1 aborted, %2"), parts)
                                  : sentence(tr("%1 aborted, %2: %3"), parts);
}

QString SdoTexts::of(const SdoFrame &sdo)
{
    switch (sdo.kind) {
    case SdoFrame::Kind::read:
        return sentence(tr("read %1"), {sdo.object.text()});
    case SdoFrame::Kind::readSegment:
        return tr("next segment");
    case SdoFrame::Kind::write:
    case SdoFrame::Kind::value:
        return value(sdo);
    case SdoFrame::Kind::writeBegins:
    case SdoFrame::Kind::valueBegins:
        return segments(sdo);
    case SdoFrame::Kind::written:
        return sentence(tr("%1 written"), {sdo.object.text()});
    case SdoFrame::Kind::segmentWritten:
        return tr("segment taken");
    case SdoFrame::Kind::segment:
        return segment(sdo);
    case SdoFrame::Kind::abort:
        return abort(sdo);
    case SdoFrame::Kind::block:
        return tr("block transfer");
    case SdoFrame::Kind::unknown:
        break;
    }
    return sdo.isAnswer ? tr("SDO answer") : tr("SDO request");
}

} // namespace

QString sdoText(const SdoFrame &sdo)
{
    return SdoTexts::of(sdo);
}

} // namespace codewheel::canopen
