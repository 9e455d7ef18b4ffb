// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure_editor/insert_panel.h"

#include "catalog/hex_code.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>

namespace codewheel {
namespace {

constexpr int visibleDevices = 5;

// "37h", "37", "0x37"
std::optional<unsigned> hexByte(QString text)
{
    text = text.trimmed().toLower();
    if (text.startsWith(QStringLiteral("0x")))
        text.remove(0, 2);
    if (text.endsWith(u'h'))
        text.chop(1);
    bool isNumber = false;
    const unsigned value = text.toUInt(&isNumber, 16);
    return isNumber && value <= 0xFF ? std::optional(value) : std::nullopt;
}

} // namespace

InsertPanel::InsertPanel(const PlanEdits &edits, QWidget *parent)
    : QWidget(parent)
    , m_edits(edits)
    , m_search(describe(new QLineEdit(this), "catalogSearch", tr("Search the catalog"),
                        tr("Shows the devices of the catalog that have these words")))
    , m_devices(describe(new QListWidget(this), "catalogDevices", tr("Devices of the catalog"),
                         tr("Enter or a double click inserts the device")))
    , m_idCode(describe(new QLineEdit(this), "insertIdCode", tr("ID code"),
                        tr("The low byte of the device code, hexadecimal: kind and direction")))
    , m_lengthCode(describe(new QLineEdit(this), "insertLengthCode", tr("Length code"),
                            tr("The high byte of the device code, hexadecimal: data width")))
    , m_codes(new QWidget(this))
    , m_codesLabel(new QLabel(tr("I&D code"), this))
    , m_reading(new QLabel(this))
    , m_where(describe(new QComboBox(this), "insertPlace", tr("Place"),
                       tr("Where the device is inserted, relative to the chosen one")))
    , m_insert(describe(new QPushButton(tr("&Insert device"), this), "insertDevice",
                        tr("Inserts the device at this place")))
    , m_change(describe(new QPushButton(tr("Chan&ge to it"), this), "changeDevice",
                        tr("Makes the chosen device of the bus one of these; station, group and addresses "
                           "stay")))
{
    makeFields();
    showKind();
    setPlace({});
    connect(m_search, &QLineEdit::textChanged, this, &InsertPanel::fillCatalog);
    connect(m_search, &QLineEdit::returnPressed, m_insert, &QPushButton::click);
    connect(m_devices, &QListWidget::currentRowChanged, this, [this] {
        m_byCode = false;
        choose();
    });
    connect(m_devices, &QListWidget::itemActivated, m_insert, &QPushButton::click);
    for (QLineEdit *field : {m_idCode, m_lengthCode}) {
        connect(field, &QLineEdit::textEdited, this, &InsertPanel::readCodes);
        connect(field, &QLineEdit::returnPressed, m_insert, &QPushButton::click);
    }
    connect(m_insert, &QPushButton::clicked, this, [this] {
        if (const auto device = chosen())
            Q_EMIT insertRequested(*device,
                                   m_targets.at(static_cast<std::size_t>(m_where->currentIndex())).where);
    });
    connect(m_change, &QPushButton::clicked, this, [this] {
        if (const auto device = chosen())
            Q_EMIT changeRequested(*device);
    });
}

void InsertPanel::makeFields()
{
    m_search->setClearButtonEnabled(true);
    m_devices->setSpacing(grid::unit / 2);
    m_devices->setFixedHeight(visibleDevices * (fontMetrics().height() + grid::unit) + grid::margin);
    for (QLineEdit *field : {m_idCode, m_lengthCode}) {
        field->setFont(numberFont());
        field->setMaxLength(4);
        field->setFixedWidth(field->fontMetrics().horizontalAdvance(u'0') * 4 + 5 * grid::margin);
    }
    m_idCode->setPlaceholderText(QStringLiteral("BEh"));
    m_lengthCode->setPlaceholderText(QStringLiteral("81h"));
    m_reading->setObjectName(QStringLiteral("insertReading"));
    m_reading->setWordWrap(true);
    m_where->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);

    const auto label = [this](const QString &text, QWidget *buddy) {
        auto *made = new QLabel(text, this);
        made->setBuddy(buddy);
        return made;
    };
    m_codesLabel->setBuddy(m_idCode);
    auto *codes = layOut<QHBoxLayout>(m_codes, grid::groupGap);
    codes->addWidget(m_idCode);
    codes->addWidget(label(tr("&Length code"), m_lengthCode));
    codes->addWidget(m_lengthCode);
    auto *reading = new QHBoxLayout;
    reading->setSpacing(grid::groupGap);
    reading->addWidget(m_codes);
    reading->addWidget(m_reading, 1);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(grid::groupGap);
    buttons->addWidget(m_where, 1);
    buttons->addWidget(m_insert);
    buttons->addWidget(m_change);
    auto *fields = new QGridLayout(this);
    fields->setContentsMargins({});
    fields->setVerticalSpacing(grid::unit);
    fields->addWidget(label(tr("C&atalog"), m_search), 0, 0);
    fields->addLayout(makeSearchRow(), 0, 1);
    fields->addWidget(m_devices, 1, 1);
    fields->addWidget(m_codesLabel, 2, 0);
    fields->addLayout(reading, 2, 1);
    fields->addWidget(label(tr("&Place"), m_where), 3, 0);
    fields->addLayout(buttons, 3, 1);
}

QHBoxLayout *InsertPanel::makeSearchRow()
{
    auto *close = describe(new QToolButton(this), "closeInsert", tr("Close the insert panel"),
                           tr("Closes this panel (Esc)"));
    close->setIcon(lineIcon(Icon::cancel));
    close->setAutoRaise(true);
    connect(close, &QToolButton::clicked, this, &InsertPanel::closeRequested);
    auto *escape = new QShortcut(Qt::Key_Escape, this);
    escape->setContext(Qt::WidgetWithChildrenShortcut);
    connect(escape, &QShortcut::activated, this, &InsertPanel::closeRequested);
    auto *row = new QHBoxLayout;
    row->setSpacing(grid::unit);
    row->addWidget(m_search, 1);
    row->addWidget(close);
    return row;
}

void InsertPanel::focusSearch()
{
    m_search->setFocus();
    m_search->selectAll();
}

void InsertPanel::showKind()
{
    const bool hasCodes = m_edits.rules().coded(0, 0).has_value();
    m_codes->setVisible(hasCodes);
    m_codesLabel->setVisible(hasCodes);
    m_byCode = false;
    m_search->clear(); // it was about the catalog of another bus
    m_search->setPlaceholderText(hasCodes ? tr("Search the catalog: maker, name, profile or ID code")
                                          : tr("Search the catalog: maker or name"));
    fillCatalog();
}

void InsertPanel::fillCatalog()
{
    m_devices->clear();
    m_offered.clear();
    const QString searched = m_search->text();
    const auto words = QStringView(searched).split(u' ', Qt::SkipEmptyParts);
    for (const Participant &device : m_edits.rules().offered(m_edits.catalog())) {
        QString text = m_edits.nameOf(device);
        if (device.deviceCode != 0)
            text += QStringLiteral("  (%1)").arg(hexCode(device.deviceCode, 4));
        if (!std::ranges::all_of(words,
                                 [&](QStringView word) { return text.contains(word, Qt::CaseInsensitive); }))
            continue;
        m_devices->addItem(text);
        m_offered.push_back(device);
    }
    if (m_devices->count() > 0)
        m_devices->setCurrentRow(0);
    choose();
}

void InsertPanel::readCodes()
{
    m_byCode = !m_idCode->text().isEmpty() || !m_lengthCode->text().isEmpty();
    choose();
}

std::optional<Participant> InsertPanel::chosen() const
{
    if (m_byCode) {
        const auto id = hexByte(m_idCode->text());
        const auto length =
            hexByte(m_lengthCode->text().isEmpty() ? QStringLiteral("0") : m_lengthCode->text());
        return id && length ? m_edits.rules().coded(*id, *length) : std::nullopt;
    }
    const int row = m_devices->currentRow();
    return row < 0 ? std::nullopt : std::optional(m_offered.at(static_cast<std::size_t>(row)));
}

// Describes what will be inserted.
void InsertPanel::choose()
{
    const auto device = chosen();
    m_insert->setEnabled(device && !m_targets.empty());
    m_change->setEnabled(device && m_hasChosen);
    if (!device)
        m_reading->setText(m_byCode ? tr("Codes are two hexadecimal digits, such as BEh and 81h.")
                                    : QString());
    else if (m_targets.empty())
        m_reading->setText(tr("Every place of this bus is taken."));
    else
        m_reading->setText(m_edits.rules().reading(*device, m_edits.catalog()));
    if (device && !m_targets.empty())
        m_where->setCurrentIndex(static_cast<int>(m_edits.rules().preferred(
            m_targets, *device, static_cast<std::size_t>(m_where->currentIndex()))));
}

void InsertPanel::setPlace(std::optional<std::size_t> chosen, std::optional<NodeId> connected)
{
    m_hasChosen = chosen.has_value();
    m_targets = m_edits.rules().targets(m_edits.project(), m_edits.bus(), chosen, connected);
    m_where->clear();
    for (const PlanTarget &target : m_targets)
        m_where->addItem(target.text);
    choose();
}

} // namespace codewheel
