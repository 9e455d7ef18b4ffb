// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/canopen_explain.h"

#include "kinds/canopen/protocol/cob_id.h"
#include "kinds/canopen/protocol/emcy.h"
#include "kinds/canopen/protocol/nmt.h"
#include "kinds/canopen/protocol/pdo_mappings_heard.h"
#include "kinds/canopen/protocol/sdo_blocks.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QDateTime>

#include <array>
#include <type_traits>

namespace codewheel::canopen {
namespace {

using Mapped = std::shared_ptr<const PdoMappingsHeard::Pdo>;

// What came before a frame and belongs to it.
struct Context
{
    std::optional<SdoBlockSegment> segment{};
    Mapped pdo{}; // null: its mapping is not known
};

// What is to be told of a frame with a short identifier: so little that a FrameText needs no memory beside
// it. There are thousands of them in a second.
class ToldFrame
{
public:
    explicit ToldFrame(const CanFrame &frame)
        : m_identifier(static_cast<std::uint16_t>(frame.id))
        , m_isRemote(frame.isRemote)
        , m_length(frame.length)
        , m_bytes(frame.bytes)
    {}

    CanFrame frame() const
    {
        return {.id = m_identifier, .isRemote = m_isRemote, .length = m_length, .bytes = m_bytes};
    }

private:
    std::uint16_t m_identifier;
    bool m_isRemote;
    std::uint8_t m_length;
    std::array<std::uint8_t, CanFrame::mostBytes> m_bytes;
};
static_assert(sizeof(ToldFrame) <= 2 * sizeof(void *) && std::is_trivially_copyable_v<ToldFrame>);

class FrameTexts
{
    Q_DECLARE_TR_FUNCTIONS(CanopenFrame)

public:
    static QString of(const CanFrame &frame, const Context &context);
    static QString mapped(const PdoMappingsHeard::Pdo &pdo, const CanFrame &frame);

private:
    static QString sync(Octets data);
    static QString time(Octets data);
    static QString emcy(const Emcy &emcy);
    static QString pdo(const CobId &cob, bool isAskedFor);
    static QString errorControl(const CanFrame &frame);
    static QString sdo(const CobId &cob, const CanFrame &frame, const Context &context);
    static QString ofNode(const CobId &cob, const CanFrame &frame, const Context &context);
    static QString ofAll(const CobId &cob, const CanFrame &frame);
    static QString odd(const CanFrame &frame);

    // What `text` makes of it; what cannot be read is odd.
    template <typename Read, typename Text>
    static QString told(const CanFrame &frame, const Read &read, Text text)
    {
        return read && !frame.isRemote ? text(*read) : odd(frame);
    }
};

// The identifier says what it should be, and its length that it is not.
QString FrameTexts::odd(const CanFrame &frame)
{
    return frame.isRemote
               ? tr("asked for by a remote frame")
               : sentence(tr("of an unexpected length (bytes: %1)"), {QString::number(frame.length)});
}

QString FrameTexts::sync(Octets data)
{
    return data.size() == 1 ? sentence(tr("SYNC %1"), {QString::number(data[0])}) : tr("SYNC");
}

// Milliseconds since midnight in 28 bits, and days since 1 January 1984.
QString FrameTexts::time(Octets data)
{
    constexpr std::size_t size = 6;
    constexpr std::uint32_t millisecondBits = 0x0FFF'FFFF;
    constexpr std::uint32_t dayMilliseconds = 86'400'000;
    if (data.size() != size)
        return tr("TIME");
    const std::uint32_t milliseconds = numberOf(data.first(4)) & millisecondBits;
    if (milliseconds >= dayMilliseconds)
        return tr("TIME");
    const QDate day = QDate(1984, 1, 1).addDays(numberOf(data.subspan(4)));
    const QTime at = QTime::fromMSecsSinceStartOfDay(static_cast<int>(milliseconds));
    return sentence(tr("TIME %1 %2"),
                    {day.toString(Qt::ISODate), at.toString(QStringLiteral("HH:mm:ss.zzz"))});
}

QString FrameTexts::emcy(const Emcy &emcy)
{
    const QStringList bits = emcy.registerTexts();
    if (bits.isEmpty())
        return sentence(tr("EMCY %1"), {emcy.text()});
    return sentence(tr("EMCY %1; error register: %2"), {emcy.text(), bits.join(QStringLiteral(", "))});
}

QString FrameTexts::pdo(const CobId &cob, bool isAskedFor)
{
    const QString number = QString::number(cob.number);
    if (cob.service == CobId::Service::rpdo)
        return sentence(QStringLiteral("RPDO%1"), {number});
    return sentence(isAskedFor ? tr("TPDO%1?") : QStringLiteral("TPDO%1"), {number});
}

QString FrameTexts::errorControl(const CanFrame &frame)
{
    if (frame.isRemote)
        return tr("guarding: which state?");
    return told(frame, NodeState::read(frame.data()), [](const NodeState &state) {
        return state.toggle ? sentence(tr("%1 (guarding, toggle bit 1)"), {state.text()}) : state.text();
    });
}

QString FrameTexts::sdo(const CobId &cob, const CanFrame &frame, const Context &context)
{
    if (const auto &segment = context.segment)
        return sentence(segment->isLast ? tr("last block segment (%1)") : tr("block segment (%1)"),
                        {QString::number(segment->number)});
    const bool isAnswer = cob.service == CobId::Service::sdoAnswer;
    return told(frame, isAnswer ? SdoFrame::answer(frame.data()) : SdoFrame::request(frame.data()), sdoText);
}

QString FrameTexts::ofNode(const CobId &cob, const CanFrame &frame, const Context &context)
{
    switch (cob.service) {
    case CobId::Service::emcy:
        return told(frame, Emcy::read(frame.data()), &FrameTexts::emcy);
    case CobId::Service::sdoRequest:
    case CobId::Service::sdoAnswer:
        return sdo(cob, frame, context);
    case CobId::Service::errorControl:
        return errorControl(frame);
    default:
        return pdo(cob, frame.isRemote);
    }
}

// Speed, acceleration and jerk have a sign (CiA 406); what others have is not told by the frames.
PdoType typeByProfile(const SdoObject &object)
{
    const bool hasSign = object.index == 0x6030 || object.index == 0x6040 || object.index == 0x6050;
    return {.isSigned = hasSign};
}

QString FrameTexts::mapped(const PdoMappingsHeard::Pdo &pdo, const CanFrame &frame)
{
    QStringList texts{sentence(QStringLiteral("TPDO%1"), {QString::number(pdo.mapping.number())})};
    for (const PdoValue &value : pdo.mapping.values(frame, typeByProfile))
        texts << sentence(QStringLiteral("%1 = %2 = %3"),
                          {value.object.text(),
                           QStringLiteral("%1h").arg(QString::number(value.raw, 16).toUpper()),
                           numberText(value.number)});
    return sentence(tr("Node %1: %2"), {QString::number(pdo.node), texts.join(QStringLiteral(", "))});
}

QString FrameTexts::ofAll(const CobId &cob, const CanFrame &frame)
{
    const Octets data = frame.data();
    switch (cob.service) {
    case CobId::Service::nmt:
        return sentence(tr("NMT: %1"), {told(frame, NmtRequest::read(data),
                                             [](const NmtRequest &nmt) { return nmt.text(); })});
    case CobId::Service::sync:
        return frame.isRemote ? sentence(tr("SYNC: %1"), {odd(frame)}) : sync(data);
    case CobId::Service::time:
        return frame.isRemote ? sentence(tr("TIME: %1"), {odd(frame)}) : time(data);
    case CobId::Service::lssRequest:
        return sentence(tr("LSS: %1"), {told(frame, LssFrame::read(data), lssRequestText)});
    default:
        return sentence(tr("LSS answer: %1"), {told(frame, LssFrame::read(data), lssAnswerText)});
    }
}

QString FrameTexts::of(const CanFrame &frame, const Context &context)
{
    const CobId cob = CobId::of(frame.id).value_or(CobId());
    return cob.node == 0
               ? ofAll(cob, frame)
               : sentence(tr("Node %1: %2"), {QString::number(cob.node), ofNode(cob, frame, context)});
}

// What is remembered of the frames before.
class Listener
{
public:
    Context next(const std::optional<CobId> &cob, const CanFrame &frame)
    {
        Context context{.pdo = m_mappings.of(frame)};
        if (!cob || frame.isRemote)
            return context;
        const bool isAnswer = cob->service == CobId::Service::sdoAnswer;
        if (isAnswer || cob->service == CobId::Service::sdoRequest)
            context.segment = followSdo(cob->node, isAnswer, frame.data());
        else if (cob->service == CobId::Service::errorControl && isBootUp(frame.data()))
            m_mappings.restarted(cob->node);
        return context;
    }

private:
    std::optional<SdoBlockSegment> followSdo(int node, bool isAnswer, Octets data)
    {
        const auto segment = m_blocks.segment(node, isAnswer, data);
        if (segment)
            return segment;
        if (const auto sdo = isAnswer ? SdoFrame::answer(data) : SdoFrame::request(data))
            m_mappings.followSdo(node, *sdo);
        return std::nullopt;
    }
    static bool isBootUp(Octets data)
    {
        const auto told = NodeState::read(data);
        return told && told->state == NmtState::bootUp && !told->toggle;
    }

    SdoBlocks m_blocks;
    PdoMappingsHeard m_mappings;
};

} // namespace

FrameMeaning frameMeaning()
{
    return [listener = Listener()](const CanFrame &frame) mutable -> FrameText {
        const auto cob = frame.isExtended || frame.isError ? std::nullopt : CobId::of(frame.id);
        Context context = listener.next(cob, frame);
        if (context.pdo)
            return [frame, pdo = std::move(context.pdo)] { return FrameTexts::mapped(*pdo, frame); };
        if (!cob)
            return nullptr;
        const ToldFrame told(frame);
        if (context.segment)
            return [told, context] { return FrameTexts::of(told.frame(), context); };
        return [told] { return FrameTexts::of(told.frame(), {}); };
    };
}

} // namespace codewheel::canopen
