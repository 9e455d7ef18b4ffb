// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/word_card.h"

#include "catalog/device_description.h"
#include "history/track.h"
#include "journal/eeprom_cost.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "widgets/eeprom/eeprom_question.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/models/age_timer.h"
#include "widgets/monitor/bar_view.h"
#include "widgets/monitor/copy_menu.h"
#include "widgets/monitor/display_menu.h"
#include "widgets/monitor/meaning_line.h"
#include "widgets/monitor/number_fields.h"
#include "widgets/monitor/word_sender.h"
#include "widgets/monitor/word_view.h"

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QShortcut>
#include <QToolButton>

#include <algorithm>

namespace codewheel {

namespace {

int bitsOf(const WordChannel &channel)
{
    return std::max(channel.inWords(), channel.outWords()) > 1 ? 32 : 16;
}

// A word shorter than the device's other one is not shown.
bool has(const WordChannel &channel, WordDirection direction)
{
    const int words = direction == WordDirection::out ? channel.outWords() : channel.inWords();
    return words > 0 && words * 16 >= bitsOf(channel);
}

std::vector<WordView::Line> bitsOf(const std::vector<WordLine *> &lines)
{
    std::vector<WordView::Line> bits;
    bits.reserve(lines.size());
    for (const WordLine *line : lines)
        bits.push_back({.caption = caption(line->direction()),
                        .place = line->name(),
                        .isEditable = line->isOut(),
                        .bitText = [line](int bit) { return line->bitText(bit); }});
    return bits;
}

QToolButton *titleButton(QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

} // namespace

bool WordCard::canShow(const WordChannel &channel)
{
    return has(channel, WordDirection::in) || has(channel, WordDirection::out);
}

WordCard::WordCard(WordChannel &channel, EncoderSession *encoder, const DeviceDescription *device,
                   QWidget *parent)
    : QFrame(parent)
    , m_channel(&channel)
    , m_encoder(encoder)
    , m_device(device)
    , m_place(channel.place())
    , m_shownPlace(m_place.shown())
    , m_menu(new DisplayMenu(this))
    , m_title(new MeaningLine(this))
    , m_pin(titleButton(this))
    , m_bar(new BarView(this))
    , m_message(new InlineMessage(this))
    , m_age(new AgeTimer(this))
{
    setFrameShape(QFrame::StyledPanel);
    setAccessibleName(tr("Monitor %1", "Monitor 1.0").arg(m_shownPlace));
    m_bar->setPlace(wordName(WordDirection::in, m_place));
    QHBoxLayout *title = makeTitle();
    makeLines();
    arrange(title);
    makeKeys();

    connect(m_bits, &WordView::bitToggled, this, &WordCard::stageBit);
    connect(m_menu, &DisplayMenu::chosen, this, [this](const MonitorDisplay &display) {
        setDisplay(display);
        Q_EMIT displayChosen(display);
    });
    connect(m_channel, &WordChannel::changed, this, [this] { m_age->follow(*m_channel); });
    connect(m_age, &QTimer::timeout, this, [this] { showWords(false); });
    m_age->follow(*m_channel);
    connect(m_message, &InlineMessage::closed, this, [this] { m_cause = Cause::none; });
    setStation({});
    setDisplay(m_display);
    showWords(false);
}

void WordCard::makeLines()
{
    const WordForm form = wordForm(bitsOf(*m_channel), m_device);
    QStringList captions;
    for (const WordDirection direction : {WordDirection::out, WordDirection::in})
        if (has(*m_channel, direction)) {
            m_lines.push_back(new WordLine(direction, {m_channel, m_encoder, m_device}, form, this));
            captions << caption(direction);
        }
    for (WordLine *line : m_lines)
        line->setCaptionWidth(WordView::captionWidth(captions));
    m_bits = new WordView(form, bitsOf(m_lines), this);
    setFocusProxy(m_bits);
    if (const WordLine *out = outLine())
        makeSender(*out->sender(), *out->numbers());
}

QHBoxLayout *WordCard::makeTitle()
{
    QFont strong = m_title->font();
    strong.setBold(true);
    m_title->setFont(strong);

    describe(m_pin, tr("Pin monitor %1", "Pin monitor 1.0").arg(m_shownPlace),
             tr("Keep this monitor when another device is chosen"));
    m_pin->setIcon(lineIcon(Icon::pin));
    m_pin->setCheckable(true);
    connect(m_pin, &QToolButton::clicked, this, &WordCard::pinToggled);

    QToolButton *show = describe(titleButton(this), tr("Display of %1", "Show of 1.0").arg(m_shownPlace),
                                 tr("Choose what all monitors show"));
    show->setText(tr("Show"));
    show->setMenu(m_menu);
    show->setPopupMode(QToolButton::InstantPopup);

    QToolButton *close =
        describe(titleButton(this), tr("Close monitor %1", "Close monitor 1.0").arg(m_shownPlace),
                 tr("Close this monitor"));
    close->setIcon(lineIcon(Icon::cancel));
    connect(close, &QToolButton::clicked, this, &WordCard::closeRequested);
    auto *row = new QHBoxLayout;
    row->setSpacing(grid::unit);
    row->addWidget(m_title, 1);
    for (QToolButton *button : {m_pin, show, close})
        row->addWidget(button);
    return row;
}

void WordCard::arrange(QHBoxLayout *title)
{
    auto *rows = layOut<QVBoxLayout>(this, grid::unit, QMargins(grid::margin, 0, grid::margin, grid::unit));
    rows->addLayout(title);
    rows->addWidget(m_bits);
    for (WordLine *line : m_lines)
        rows->addWidget(line);
    rows->addWidget(m_bar);
    if (m_channel->outWords() == 0) {
        QLabel *note = wrappedLabel(this, "noOut");
        note->setText(tr("%1 has no OUT word: nothing can be sent to it.", "1.0").arg(m_shownPlace));
        rows->addWidget(note);
    }
    rows->addWidget(m_message);
    orderTabs(*title);
}

// What is done to the word comes before what is done to the card.
void WordCard::orderTabs(const QLayout &title)
{
    QWidget *last = m_bits;
    const auto add = [&last](QWidget *widget) {
        if ((widget->focusPolicy() & Qt::TabFocus) != 0)
            setTabOrder(std::exchange(last, widget), widget);
    };
    for (const WordLine *line : m_lines)
        for (QWidget *field : line->findChildren<QWidget *>())
            add(field);
    for (int i = 0; i < title.count(); ++i)
        if (QWidget *button = title.itemAt(i)->widget())
            add(button);
}

void WordCard::setStation(const QString &station)
{
    QStringList parts{m_shownPlace};
    if (!station.isEmpty())
        parts << station;
    if (m_device != nullptr)
        parts << m_device->fullName();
    m_title->setText(parts.join(QStringLiteral("  ")));
}

QString WordCard::title() const
{
    return m_title->text();
}

bool WordCard::isNamedAnew() const
{
    return m_place.shown() != m_shownPlace;
}

void WordCard::setPinned(bool pinned)
{
    m_pin->setChecked(pinned);
}

bool WordCard::isPinned() const
{
    return m_pin->isChecked();
}

const WordLine *WordCard::line(WordDirection direction) const
{
    const auto found = std::ranges::find(m_lines, direction, &WordLine::direction);
    return found == m_lines.end() ? nullptr : *found;
}

WordLine *WordCard::outLine() const
{
    return !m_lines.empty() && m_lines.front()->isOut() ? m_lines.front() : nullptr;
}

// That of the fields in use, otherwise that of the bits.
const WordLine &WordCard::chosenLine() const
{
    const auto focused = std::ranges::find_if(m_lines, [](const WordLine *line) {
        const QWidget *focus = QApplication::focusWidget();
        return focus != nullptr && line->isAncestorOf(focus);
    });
    return focused != m_lines.end() ? **focused
                                    : *m_lines[static_cast<std::size_t>(m_bits->focusedBit().word)];
}

void WordCard::makeSender(WordSender &sender, NumberFields &numbers)
{
    sender.setGate([this](Word word) {
        return !m_encoder || askForEeprom(window(), *m_encoder, mostEepromWrites(*m_encoder, word));
    });
    connect(m_channel, &WordChannel::stagedChanged, this, [this, &sender] {
        if (!m_channel->staged())
            m_hasSent = false;
        withdraw(Cause::refusal);
        withdraw(Cause::question);
        sender.showStaged();
        showWords(false);
    });
    connect(m_channel, &WordChannel::refused, this, [this](const Refusal &why) {
        if (m_hasSent)
            showRefusal(why);
    });
    numbers.hexadecimal()->setAcceptDrops(false); // a device is dropped on the card
    connect(&numbers, &NumberFields::wordTyped, this, &WordCard::stageTyped);
    connect(&numbers, &NumberFields::problemChanged, this, &WordCard::showProblem);
    connect(&numbers, &NumberFields::entered, &sender, &WordSender::edited);
    connect(numbers.hexadecimal(), &QLineEdit::editingFinished, this, [this] { m_isTyping = false; });
    connect(&sender, &WordSender::refused, this, &WordCard::showRefusal);
    connect(&sender, &WordSender::askedFor, this, &WordCard::askBeforeSending);
    connect(&sender, &WordSender::sent, this, [this, &numbers] {
        m_hasSent = true;
        if (numbers.hexadecimal()->hasFocus())
            numbers.hexadecimal()->selectAll(); // the next word typed replaces it
        withdraw(Cause::refusal);
        withdraw(Cause::question);
    });
    connect(&sender, &WordSender::discarded, &numbers, &NumberFields::restore);
    connect(m_message, &InlineMessage::actionTriggered, &sender, &WordSender::write);
}

void WordCard::makeKeys()
{
    const auto onKey = [this](const QKeySequence &key, auto action) {
        auto *shortcut = new QShortcut(key, this);
        shortcut->setContext(Qt::WidgetWithChildrenShortcut);
        connect(shortcut, &QShortcut::activated, this, action);
    };
    if (const WordLine *out = outLine()) {
        WordSender *sender = out->sender();
        for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter})
            onKey(QKeySequence(Qt::CTRL | key), [sender] { sender->write(); });
        onKey(QKeySequence(Qt::Key_Escape), [sender] { sender->discard(); });
    }
    auto *hexadecimal = new QAction(lineIcon(Icon::copy), tr("Copy as hexadecimal"), this);
    hexadecimal->setShortcut(QKeySequence::Copy);
    hexadecimal->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(hexadecimal, &QAction::triggered, this, [this] { copy(WordNotation::hexadecimal); });
    auto *menu = new CopyMenu(this);
    connect(menu, &CopyMenu::chosen, this, &WordCard::copy);
    addAction(hexadecimal);
    if (m_bits->bits() == 32)
        addAction(menu->plcWords());
    addAction(menu->menuAction());
    makeTrendActions();
    setContextMenuPolicy(Qt::ActionsContextMenu);
}

// Of the word that was chosen last, and of the bit that was.
void WordCard::makeTrendActions()
{
    const auto channelOf = [](const WordLine &line) {
        return line.direction() == WordDirection::in ? Channel::in : Channel::out;
    };
    auto *bit = new QAction(lineIcon(Icon::trend), tr("Show &bit in trend"), this);
    connect(bit, &QAction::triggered, this, [this, channelOf] {
        const WordBit chosen = m_bits->focusedBit();
        Q_EMIT trendWanted({m_place, channelOf(*m_lines[static_cast<std::size_t>(chosen.word)]),
                            static_cast<unsigned>(chosen.bit)});
    });
    auto *word = new QAction(lineIcon(Icon::trend), tr("Show &word in trend"), this);
    connect(word, &QAction::triggered, this, [this, channelOf] {
        Q_EMIT trendWanted({m_place, channelOf(chosenLine()), {}});
    });
    addActions({bit, word});
}

void WordCard::copy(WordNotation notation)
{
    QApplication::clipboard()->setText(chosenLine().copiedText(notation));
}

void WordCard::setDisplay(const MonitorDisplay &display)
{
    m_display = display;
    m_menu->setDisplay(display);
    m_bits->setMatrix(display.matrix);
    for (WordLine *line : m_lines)
        line->setDisplay(display);
    m_bar->setVisible(display.bar && line(WordDirection::in) != nullptr);
    showRange();
}

void WordCard::stageBit(WordBit bit)
{
    const WordLine *out = outLine();
    if (!m_channel || out == nullptr)
        return;
    m_channel->stage(out->shown() ^ (Word{1} << bit.bit));
    out->sender()->edited();
}

void WordCard::stageTyped(Word word)
{
    if (!m_channel)
        return;
    if (!std::exchange(m_isTyping, true))
        m_stagedBefore = m_channel->staged();
    m_channel->stage(word);
}

// A word typed on the way to bad input must not be sent.
void WordCard::showProblem(const QString &sentence)
{
    withdraw(Cause::badInput);
    outLine()->sender()->setBlocked(!sentence.isEmpty());
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

void WordCard::showFrame(Instant now)
{
    m_now = now;
    showWords(true);
    showRange();
}

void WordCard::showWords(bool withEdges)
{
    if (!m_channel)
        return;
    int row = 0;
    for (WordLine *line : m_lines) {
        m_bits->setWord(row, line->shown(), line->onBus(), withEdges ? line->edges() : 0, m_now);
        m_bits->setOld(row, line->isOld());
        m_bits->setKnown(row, line->isKnown());
        line->showWord();
        ++row;
    }
}

void WordCard::showRange()
{
    if (!m_encoder || !m_display.bar)
        return;
    const auto range = positionRange(*m_encoder);
    if (range && range != m_range)
        m_bar->setRange(range->first, range->last);
    m_range = range;
    m_bar->setValue(m_range ? m_encoder->latest().position : std::nullopt, m_lines.back()->isOld());
}

void WordCard::showRefusal(const Refusal &why)
{
    m_message->showMessage(why.kind == RefusalKind::link ? Role::fault : Role::attention, refusalText(why));
    m_cause = Cause::refusal;
}

void WordCard::askBeforeSending(Word word)
{
    m_message->showMessage(
        Role::attention,
        tr("%1 has a command bit or a parameter number, so it is not sent at once. Send it?")
            .arg(hexWord(word)),
        tr("Send %1", "a word").arg(hexWord(word)));
    m_cause = Cause::question;
}

void WordCard::withdraw(Cause cause)
{
    if (m_cause != cause)
        return;
    m_message->withdraw();
    m_cause = Cause::none;
}

void WordCard::busStateChanged()
{
    withdraw(Cause::refusal);
}

} // namespace codewheel
