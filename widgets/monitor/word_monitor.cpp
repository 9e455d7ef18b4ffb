// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/word_monitor.h"

#include "catalog/explain_word.h"
#include "encoder/hex.h"
#include "encoder/refusal_text.h"
#include "journal/eeprom_cost.h"
#include "widgets/eeprom/eeprom_question.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/models/age_text.h"
#include "widgets/models/age_timer.h"
#include "widgets/monitor/bar_view.h"
#include "widgets/monitor/display_menu.h"
#include "widgets/monitor/meaning_line.h"
#include "widgets/monitor/number_fields.h"
#include "widgets/monitor/word_format.h"
#include "widgets/monitor/word_sender.h"
#include "widgets/monitor/word_view.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>

namespace codewheel {

namespace {

constexpr int highHalfShift = 16;

} // namespace

WordMonitor::WordMonitor(WordChannel &channel, EncoderSession *encoder, const DeviceDescription *device,
                         MonitorKind kind, QWidget *parent)
    : QFrame(parent)
    , m_channel(&channel)
    , m_encoder(encoder)
    , m_device(device)
    , m_kind(kind)
    , m_place(channel.place())
    , m_wordName(wordPlace(kind, m_place))
    , m_menu(new DisplayMenu(kind, this))
    , m_bits(new WordView(wordForm(kind, device), this))
    , m_meaning(new MeaningLine(this))
    , m_places(new NumberFields(m_wordName, wordForm(kind, device), isOut(), this))
    , m_message(new InlineMessage(this))
    , m_age(new AgeTimer(this))
{
    setFrameShape(QFrame::StyledPanel);
    setAccessibleName(tr("Monitor %1", "Monitor OUT 1.0").arg(m_wordName));
    m_bits->setPlace(m_wordName);
    m_bits->setEditable(isOut());
    setFocusProxy(m_bits);
    m_bits->setBitText([this](int bit) {
        return m_channel && m_device ? bitText(*m_device, directionOf(m_kind), bit + shift()) : QString();
    });
    if (kind == MonitorKind::in32) {
        m_bar = new BarView(this);
        m_bar->setPlace(m_wordName);
    }
    if (isOut())
        makeSender();
    makeBody(makeTitle());
    makeKeys();

    connect(m_menu, &DisplayMenu::chosen, this, [this](const MonitorDisplay &display) {
        setDisplay(display);
        Q_EMIT displayChosen(display);
    });
    connect(m_channel, &WordChannel::changed, this, [this] { m_age->follow(m_channel->freshness()); });
    connect(m_age, &QTimer::timeout, this, [this] { showWord(0); });
    m_age->follow(m_channel->freshness());
    connect(m_message, &InlineMessage::closed, this, [this] { m_cause = Cause::none; });
    setDisplay(m_display);
    showWord(0);
}

QHBoxLayout *WordMonitor::makeTitle()
{
    auto *row = new QHBoxLayout;
    row->setSpacing(grid::groupGap);
    auto *title = new QLabel(
        m_device ? QStringLiteral("%1  %2").arg(m_wordName, m_device->fullName()) : m_wordName, this);
    QFont strong = title->font();
    strong.setBold(true);
    title->setFont(strong);
    title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row->addWidget(title, 1);

    if (m_kind == MonitorKind::in16 && m_channel->inWords() > 1) {
        m_half = describe(new QComboBox(this), tr("%1 half", "IN 1.0 half").arg(m_wordName),
                          tr("Which half of the 32 bits is shown"));
        m_half->addItems({QStringLiteral("D31..D16"), QStringLiteral("D15..D0")});
        m_half->setCurrentIndex(1);
        row->addWidget(m_half);
        connect(m_half, &QComboBox::currentIndexChanged, this, [this] { showWord(0); });
    }

    auto *show = describe(new QToolButton(this), tr("Show of %1", "Show of OUT 1.0").arg(m_wordName),
                          tr("Choose what this kind of monitor shows"));
    show->setText(tr("Show"));
    show->setMenu(m_menu);
    show->setPopupMode(QToolButton::InstantPopup);
    show->setAutoRaise(true);
    show->setFocusPolicy(Qt::StrongFocus);
    row->addWidget(show);

    auto *close = new QToolButton(this);
    describe(close, tr("Close monitor %1", "Close monitor OUT 1.0").arg(m_wordName),
             tr("Close this monitor"));
    close->setIcon(lineIcon(Icon::cancel));
    close->setAutoRaise(true);
    close->setFocusPolicy(Qt::StrongFocus);
    connect(close, &QToolButton::clicked, this, &WordMonitor::closeRequested);
    row->addWidget(close);
    return row;
}

bool WordMonitor::isNamedAnew() const
{
    return wordPlace(m_kind, m_place) != m_wordName;
}

void WordMonitor::makeBody(QHBoxLayout *title)
{
    auto *rows =
        layOut<QVBoxLayout>(this, grid::unit, QMargins(grid::margin, grid::unit, grid::margin, grid::margin));
    rows->addLayout(title);
    rows->addWidget(m_bits);
    rows->addWidget(m_meaning);
    if (m_bar)
        rows->addWidget(m_bar);
    rows->addWidget(m_places);
    if (m_channel->outWords() == 0)
        rows->addWidget(makeNoOutNote());
    if (m_sender)
        rows->addWidget(m_sender);
    rows->addWidget(m_message);
}

QLabel *WordMonitor::makeNoOutNote()
{
    auto *note =
        new QLabel(tr("%1 has no OUT word: nothing can be sent to it.", "1.0").arg(m_place.shown()), this);
    note->setObjectName(QStringLiteral("noOut"));
    note->setWordWrap(true);
    note->setFont(textFont(TextSize::small));
    return note;
}

void WordMonitor::makeSender()
{
    m_sender = new WordSender(*m_channel, m_wordName, wordForm(m_kind, m_device), this);
    m_sender->setGate([this](Word word) {
        return !m_encoder || askForEeprom(window(), *m_encoder, mostEepromWrites(*m_encoder, word));
    });
    connect(m_channel, &WordChannel::stagedChanged, this, [this] {
        if (!m_channel->staged())
            m_hasSent = false;
        withdraw(Cause::refusal);
        withdraw(Cause::question);
        m_sender->showStaged();
        showWord(0);
    });
    connect(m_channel, &WordChannel::refused, this, [this](const Refusal &why) {
        if (m_hasSent)
            showRefusal(why);
    });
    connect(m_bits, &WordView::bitToggled, this, [this](int bit) {
        if (!m_channel)
            return;
        m_channel->stage(shownWord() ^ (Word{1} << bit));
        m_sender->edited();
    });
    connect(m_places, &NumberFields::wordTyped, this, &WordMonitor::stageTyped);
    connect(m_places, &NumberFields::problemChanged, this, &WordMonitor::showProblem);
    connect(m_places, &NumberFields::entered, m_sender, &WordSender::edited);
    connect(m_places->hexadecimal(), &QLineEdit::editingFinished, this, [this] { m_isTyping = false; });
    connect(m_sender, &WordSender::refused, this, &WordMonitor::showRefusal);
    connect(m_sender, &WordSender::askedFor, this, &WordMonitor::askBeforeSending);
    connect(m_sender, &WordSender::sent, this, [this] {
        m_hasSent = true;
        withdraw(Cause::refusal);
        withdraw(Cause::question);
    });
    connect(m_sender, &WordSender::discarded, m_places, &NumberFields::restore);
    connect(m_message, &InlineMessage::actionTriggered, m_sender, &WordSender::write);
}

void WordMonitor::makeKeys()
{
    const auto onKey = [this](const QKeySequence &key, auto action) {
        auto *shortcut = new QShortcut(key, this);
        shortcut->setContext(Qt::WidgetWithChildrenShortcut);
        connect(shortcut, &QShortcut::activated, this, action);
    };
    if (m_sender) {
        for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter})
            onKey(QKeySequence(Qt::CTRL | key), [this] { m_sender->write(); });
        onKey(QKeySequence(Qt::Key_Escape), [this] { m_sender->discard(); });
    }
    addCopyAction(tr("Copy as hexadecimal"), QKeySequence::Copy, &WordMonitor::hexText);
    if (bitsOf(m_kind) == 32)
        addCopyAction(tr("Copy as two words of a PLC"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C),
                      &WordMonitor::plcText);
    setContextMenuPolicy(Qt::ActionsContextMenu);
}

void WordMonitor::addCopyAction(const QString &text, const QKeySequence &key,
                                QString (WordMonitor::*content)() const)
{
    QAction *action = new QAction(lineIcon(Icon::copy), text, this);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(action, &QAction::triggered, this,
            [this, content] { QApplication::clipboard()->setText((this->*content)()); });
    addAction(action);
}

void WordMonitor::setDisplay(const MonitorDisplay &display)
{
    m_display = display;
    m_menu->setDisplay(display);
    m_bits->setMatrix(display.matrix);
    m_places->setDisplay(display);
    if (m_bar)
        m_bar->setVisible(display.bar);
}

void WordMonitor::setHighHalf(bool high)
{
    if (m_half)
        m_half->setCurrentIndex(high ? 0 : 1);
}

bool WordMonitor::isHighHalf() const
{
    return m_half && m_half->currentIndex() == 0;
}

int WordMonitor::shift() const
{
    return isHighHalf() ? highHalfShift : 0;
}

Word WordMonitor::onBus() const
{
    return isOut() ? m_channel->out() : m_channel->in();
}

Word WordMonitor::shownWord() const
{
    return isOut() ? m_channel->shownOut() : m_channel->in();
}

QString WordMonitor::meaning() const
{
    return m_meaning->text();
}

QString WordMonitor::hexText() const
{
    return bitsOf(m_kind) == 16 ? hexWord(m_bits->word()).last(4) : hexWord(m_bits->word());
}

QString WordMonitor::plcText() const
{
    return plcWordsText(m_bits->word());
}

void WordMonitor::stageTyped(Word word)
{
    if (!m_channel)
        return;
    if (!std::exchange(m_isTyping, true))
        m_stagedBefore = m_channel->staged();
    m_channel->stage(word);
}

// What was a word on the way to bad input is not to be sent.
void WordMonitor::showProblem(const QString &sentence)
{
    withdraw(Cause::badInput);
    m_sender->setBlocked(!sentence.isEmpty());
    if (sentence.isEmpty())
        return;
    if (m_channel && m_isTyping) {
        if (m_stagedBefore)
            m_channel->stage(*m_stagedBefore);
        else
            m_channel->unstage();
    }
    m_message->showMessage(Role::attention, sentence);
    m_cause = Cause::badInput;
}

void WordMonitor::showPicture(Instant now)
{
    if (!m_channel)
        return;
    m_now = now;
    showWord(isOut() ? m_channel->outEdges() : m_channel->inEdges());
    if (m_bar)
        showRange();
}

void WordMonitor::showWord(Word edges)
{
    if (!m_channel)
        return;
    const Word mask = bitsOf(m_kind) == 16 ? 0xFFFF : ~Word{0};
    const auto part = [this, mask](Word word) { return word >> shift() & mask; };
    m_bits->setWord(part(shownWord()), part(onBus()), part(edges), m_now);
    m_bits->setOld(isOld());
    m_places->setWord(part(shownWord()));
    m_places->setOld(isOld());
    m_meaning->setText(explain());
}

// OUT is what goes out when the bus runs again; without a connection it is of before as well.
bool WordMonitor::isOld() const
{
    const Freshness &freshness = m_channel->freshness();
    return freshness.isOld() && (!isOut() || freshness.reason() == Freshness::Reason::disconnected);
}

void WordMonitor::showRange()
{
    if (!m_encoder || !m_display.bar)
        return;
    const auto range = positionRange(*m_encoder);
    if (range && range != m_range)
        m_bar->setRange(range->first, range->last);
    m_range = range;
    m_bar->setValue(m_range ? m_encoder->latest().position : std::nullopt, isOld());
}

QString WordMonitor::explain() const
{
    if (!m_device)
        return tr("Not explained: there is no description of this device.");
    k3::ExplainContext context;
    context.direction = directionOf(m_kind);
    context.counterpart = isOut() ? m_channel->in() : m_channel->out();
    if (m_encoder) {
        context.mode = m_encoder->latest().mode;
        context.coding = m_encoder->latest().coding;
    }
    const QString text = explanationText(*m_device, explainWord(*m_device, shownWord(), context));
    if (isOut())
        return m_channel->staged() ? tr("Not sent yet: %1", "meaning of a word").arg(text) : text;
    return isOld()
               ? tr("Not up to date, %1: %2", "20 s ago, meaning of a word").arg(ageText(*m_channel), text)
               : text;
}

void WordMonitor::showRefusal(const Refusal &why)
{
    m_message->showMessage(why.kind == RefusalKind::link ? Role::fault : Role::attention, refusalText(why));
    m_cause = Cause::refusal;
}

void WordMonitor::askBeforeSending(Word word)
{
    m_message->showMessage(
        Role::attention,
        tr("%1 has a command bit or a parameter number, so it is not sent at once. Send it?")
            .arg(hexWord(word)),
        tr("Send %1", "a word").arg(hexWord(word)));
    m_cause = Cause::question;
}

void WordMonitor::withdraw(Cause cause)
{
    if (m_cause != cause)
        return;
    m_message->withdraw();
    m_cause = Cause::none;
}

void WordMonitor::busStateChanged()
{
    withdraw(Cause::refusal);
}

} // namespace codewheel
