// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/number_fields.h"

#include "vocabulary/hex.h"
#include "vocabulary/word.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/look/on_event.h"
#include "widgets/monitor/word_format.h"

#include <QLabel>

namespace codewheel {

namespace {

const QString widestNumber = QStringLiteral("-2147483648");
const QString notThere = QStringLiteral("–");
const QString widestHex = QStringLiteral("0x020000FF");

// The largest number of so many bits.
QString widestOf(int bits)
{
    return decimalText(~Word{0}, bits);
}

} // namespace

NumberFields::NumberFields(const QString &place, const WordForm &form, bool editable, QWidget *parent)
    : QWidget(parent)
    , m_form(form)
    , m_hex(new WordField(widestHex, this))
    , m_decimal(new NumberField(widestOf(form.bits), this))
    , m_more(new QWidget(parent))
    , m_signed(new NumberField(widestNumber, m_more))
    , m_gray(new NumberField(widestNumber, m_more))
    , m_binary(new NumberField(binaryText(0, form.bits), m_more))
{
    m_hex->setAccessibleName(tr("%1 hexadecimal", "OUT 1.0 hexadecimal").arg(place));
    m_decimal->setAccessibleName(tr("%1 decimal", "OUT 1.0 decimal").arg(place));
    m_signed->setAccessibleName(tr("%1 signed", "OUT 1.0 signed").arg(place));
    m_gray->setAccessibleName(tr("%1 Gray", "OUT 1.0 Gray").arg(place));
    m_binary->setAccessibleName(tr("%1 binary", "OUT 1.0 binary").arg(place));
    layOutRow(this, {m_hex, m_decimal}, {grid::unit, QMargins()});
    const LayoutRoom room{grid::unit, {}};
    layOutColumn(m_more,
                 {layOutRow({captionOf(m_signed, tr("Signed")), m_signed, captionOf(m_gray, tr("Gray")),
                             m_gray, Stretch{1}},
                            room),
                  layOutRow({captionOf(m_binary, tr("Binary")), m_binary, Stretch{1}}, room)},
                 {grid::unit, QMargins()});

    m_hex->setReadOnly(!editable);
    m_hex->setToolTip(editable ? tr("Type the word: 020000FF, 0x020000FF, 20000FFh; spaces are allowed")
                               : tr("The whole word, as the manuals write it"));
    connect(m_hex, &WordField::typed, this, &NumberFields::hexTyped);
    connect(m_hex, &QLineEdit::returnPressed, this, [this] {
        if (m_hex->hasProblem() || m_hex->isReadOnly())
            return;
        m_hex->selectAll();
        Q_EMIT entered();
    });
    connect(m_hex, &QLineEdit::editingFinished, this, &NumberFields::hexLeft);
    setDisplay(m_display);
    showNumbers();
    onEvent(this, {QEvent::PaletteChange}, [this] {
        if (m_old)
            showAge();
    });
}

void NumberFields::setOld(bool old)
{
    if (std::exchange(m_old, old) != old)
        showAge();
}

void NumberFields::setKnown(bool known)
{
    if (std::exchange(m_isKnown, known) == known)
        return;
    restore();
    showNumbers();
}

// Captions keep their colour, which has a role of its own.
void NumberFields::showAge()
{
    const std::initializer_list<QWidget *> fields{m_hex, m_decimal, m_signed, m_gray, m_binary};
    for (QWidget *field : fields) {
        QPalette colors;
        if (m_old)
            for (const auto group : {QPalette::Active, QPalette::Inactive})
                colors.setColor(group, QPalette::Text, palette().color(group, QPalette::PlaceholderText));
        colors.setResolveMask(m_old ? colors.resolveMask() : 0);
        field->setPalette(colors);
    }
}

QLabel *NumberFields::captionOf(QWidget *field, const QString &caption)
{
    auto *label = new QLabel(caption, m_more);
    label->setFont(textFont(TextSize::small));
    label->setBuddy(field);
    m_captions.insert(field, label);
    return label;
}

void NumberFields::show(QWidget *field, bool shown)
{
    field->setVisible(shown);
    m_captions.value(field)->setVisible(shown);
}

void NumberFields::setWord(Word word)
{
    const bool isOther = std::exchange(m_word, word) != word;
    const bool isTyped = m_hex->hasFocus() && (m_hex->hasProblem() || parseHexWord(m_hex->text()) == word);
    if (!isTyped && (isOther || !m_hex->hasProblem()))
        restore();
    if (isOther)
        showNumbers();
}

void NumberFields::setDisplay(const MonitorDisplay &display)
{
    m_display = display;
    m_decimal->setVisible(display.decimal);
    show(m_signed, display.signedDecimal);
    show(m_gray, display.gray);
    show(m_binary, display.binary);
    m_more->setVisible(display.signedDecimal || display.gray || display.binary);
    const bool dataOnly = numberBits() < m_form.bits;
    const QString dataBits = QStringLiteral("D%1..D0").arg(m_form.dataBits - 1);
    m_decimal->setToolTip(dataOnly ? tr("%1 as a number", "D24..D0").arg(dataBits)
                                   : tr("The whole word as a number"));
    m_signed->setToolTip(dataOnly ? tr("%1 as a signed number (two's complement)", "D24..D0").arg(dataBits)
                                  : tr("The whole word as a signed number (two's complement)"));
    m_gray->setToolTip(dataOnly
                           ? tr("The number that %1 give when read as Gray code", "D24..D0").arg(dataBits)
                           : tr("The number that the whole word gives when read as Gray code"));
    m_binary->setToolTip(tr("All bits, the highest first"));
    showNumbers();
}

int NumberFields::numberBits() const
{
    return m_display.wholeWord ? m_form.bits : m_form.dataBits;
}

void NumberFields::showNumbers()
{
    if (m_display.decimal)
        m_decimal->showText(known(decimalText(m_word, numberBits())));
    if (m_display.signedDecimal)
        m_signed->showText(known(signedText(m_word, numberBits())));
    if (m_display.gray)
        m_gray->showText(known(grayText(m_word, numberBits())));
    if (m_display.binary)
        m_binary->showText(known(binaryText(m_word, m_form.bits)));
}

QString NumberFields::known(const QString &number) const
{
    return m_isKnown ? number : notThere;
}

void NumberFields::hexTyped(const QString &text)
{
    const std::optional<Word> word = parseHexWord(text);
    // An empty field is the beginning of an input.
    setProblem(word || text.isEmpty() ? QString() : hexProblem(text));
    if (word)
        Q_EMIT wordTyped(*word);
}

void NumberFields::hexLeft()
{
    if (!m_hex->hasProblem())
        m_hex->showText(known(hexWord(m_word)));
}

void NumberFields::restore()
{
    setProblem({});
    m_hex->showText(known(hexWord(m_word)));
}

void NumberFields::setProblem(const QString &sentence)
{
    const bool changes = m_hex->hasProblem() || !sentence.isEmpty();
    m_hex->setProblem(sentence);
    if (changes)
        Q_EMIT problemChanged(sentence);
}

} // namespace codewheel
