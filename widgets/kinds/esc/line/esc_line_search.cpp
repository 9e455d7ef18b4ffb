// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/line/esc_line_search.h"

#include "kinds/esc/line/esc_line_session.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/input/number_fields.h"
#include "widgets/kinds/esc/line/found_encoder_model.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/fitted_columns.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/quiet_table.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>

namespace codewheel {
namespace {

QString lettersAndDigits(QString text)
{
    return text.removeIf([](QChar sign) { return !sign.isLetterOrNumber(); }).toUpper();
}

const std::vector<int> allRates{19'200, 9'600, 4'800};

// An address as printed on the encoder: shows both readings.
class AddressField : public IntegerField
{
public:
    using IntegerField::IntegerField;

protected:
    QString textFromValue(int value) const override
    {
        return EscLineAddress{static_cast<std::uint8_t>(value)}.shown();
    }
    tl::expected<int, QString> read(const QString &bare) const override
    {
        const auto address = EscLineAddress::fromWire(bare.left(bare.indexOf(u'h')).trimmed());
        if (address && address->value >= minimum() && address->value <= maximum())
            return address->value;
        return tl::unexpected(
            EscLineSearch::tr("\"%1\" is not an address. Give two hexadecimal digits, 01 to 1F.").arg(bare));
    }
};

QSpinBox *addressField(int value, const QString &name, QWidget *parent)
{
    auto *field =
        describe(new AddressField(parent), name, EscLineSearch::tr("Two hexadecimal digits, 01 to 1F"));
    field->setRange(1, EscLineAddress::last);
    field->setValue(value);
    return field;
}

} // namespace

EscLineSearch::EscLineSearch(QWidget *parent)
    : Page(parent)
    , m_first(addressField(1, tr("First address"), this))
    , m_last(addressField(EscLineAddress::last, tr("Last address"), this))
    , m_rates(describe(new QComboBox(this), tr("Baud rates of the search"),
                       tr("An encoder answers at its own baud rate alone; 19200 is that of the factory")))
    , m_master(new QCheckBox(tr("Ask at the &master address 00 first"), this))
    , m_device(describe(new QComboBox(this), tr("Kind of encoder"),
                        tr("The kind that the ticked encoders are taken over as: they do not report whether "
                           "they have RS-422 or RS-485")))
    , m_progress(new QProgressBar(this))
    , m_message(new InlineMessage(this))
    , m_found(new FoundEncoderModel(this))
    , m_content(new QStackedWidget(this))
    , m_table(new QTableView(this))
    , m_empty(new EmptyState(Icon::search, tr("No search yet"),
                             tr("Each address is asked for its serial number. Nothing is written."), this))
{
    setAccessibleName(tr("Search for encoders"));
    auto *rows = layOut<QVBoxLayout>(this, grid::margin, grid::unit);
    makeFields();
    rows->addWidget(m_progress);
    rows->addWidget(m_message);
    makeTable();
    rows->addWidget(m_content, 1);
    auto *below = new QHBoxLayout;
    m_device->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    auto *kind = new QLabel(tr("&Kind"), this);
    kind->setBuddy(m_device);
    below->addWidget(kind);
    below->addWidget(m_device, 1);
    m_take = addButton(*below, lineIcon(Icon::add), tr("&Take over"),
                       tr("Adds the ticked encoders to the bus structure"));
    rows->addLayout(below);
    QWidget *before = m_first;
    for (QWidget *next : std::initializer_list<QWidget *>{m_last, m_master, m_rates, m_start, m_cancel,
                                                          m_table, m_device, m_take}) {
        setTabOrder(before, next);
        before = next;
    }
    setFocusProxy(m_start);
    connect(m_start, &QPushButton::clicked, this, &EscLineSearch::start);
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        if (m_line)
            m_line->cancelScan();
    });
    connect(m_take, &QPushButton::clicked, this,
            [this] { Q_EMIT takeOverWanted(m_found->chosen(), m_device->currentData().toString()); });
    connect(m_found, &FoundEncoderModel::chosenChanged, this, &EscLineSearch::showWhatIsPossible);
    showWhatIsPossible();
}

EscLineSearch::~EscLineSearch()
{
    m_table->setModel(nullptr);
}

void EscLineSearch::makeFields()
{
    auto *form = makeForm(nullptr, grid::unit);
    auto *addresses = new QHBoxLayout;
    addresses->setSpacing(grid::groupGap);
    addresses->addWidget(m_first);
    auto *to = new QLabel(tr("t&o"), this);
    to->setBuddy(m_last);
    addresses->addWidget(to);
    addresses->addWidget(m_last);
    addresses->addStretch(1);
    form->addRow(tr("&Addresses"), addresses);
    qobject_cast<QLabel *>(form->labelForField(addresses))->setBuddy(m_first);
    m_master->setToolTip(
        tr("Any encoder answers there: only where a single one is on the line, since several "
           "would answer at once"));
    form->addRow(m_master);
    auto *condition = new QLabel(m_master->toolTip(), this);
    condition->setWordWrap(true);
    condition->setVisible(false);
    form->addRow(condition);
    connect(m_master, &QCheckBox::toggled, condition, &QWidget::setVisible);
    for (const int rate : allRates)
        m_rates->addItem(sentence(tr("%1 Bd"), {QString::number(rate)}), rate);
    m_rates->addItem(tr("All three baud rates"));
    auto *start = new QHBoxLayout;
    start->setSpacing(grid::unit);
    start->addWidget(m_rates);
    m_start = addButton(*start, lineIcon(Icon::search), tr("&Search"), {});
    m_cancel = addButton(*start, lineIcon(Icon::cancel), tr("&Cancel"), tr("Ends the search"));
    start->addStretch(1);
    form->addRow(tr("Baud &rate"), start);
    qobject_cast<QLabel *>(form->labelForField(start))->setBuddy(m_rates);
    static_cast<QVBoxLayout *>(layout())->addLayout(form);
    m_progress->setAccessibleName(tr("Progress of the search"));
    m_progress->hide();
}

void EscLineSearch::makeTable()
{
    setUpQuietTable(*m_table, *m_found, tr("Encoders found"));
    m_table->setToolTip(tr("Space chooses an encoder"));
    FittedColumns::useIn(*m_table, FoundEncoderModel::version);
    m_content->addWidget(m_empty);
    m_content->addWidget(m_table);
}

QPushButton *EscLineSearch::addButton(QLayout &row, const QIcon &icon, const QString &text,
                                      const QString &toolTip)
{
    auto *button = new QPushButton(icon, text, this);
    button->setAutoDefault(false);
    button->setToolTip(toolTip);
    row.addWidget(button);
    return button;
}

void EscLineSearch::setLine(EscLineSession *line)
{
    if (m_line)
        m_line->disconnect(this);
    m_line = line;
    m_isSearching = false;
    m_progress->hide();
    if (line) {
        ScanWish atItsRate = wish();
        atItsRate.baudRates = {line->settings().baudRate};
        setSettings(atItsRate);
        connect(line, &EscLineSession::scanProgressed, this, &EscLineSearch::showProgress);
        connect(line, &EscLineSession::scanEnded, this, &EscLineSearch::showEnd);
        connect(line, &EscLineSession::stateChanged, this, &EscLineSearch::showWhatIsPossible);
        connect(line, &QObject::destroyed, this, [this] { setLine(nullptr); });
    }
    showWhatIsPossible();
}

void EscLineSearch::setDevices(const std::vector<Device> &devices)
{
    m_device->clear();
    for (const Device &device : devices)
        m_device->addItem(device.name, device.key);
}

ScanWish EscLineSearch::wish() const
{
    ScanWish wish;
    const QVariant rate = m_rates->currentData();
    wish.baudRates = rate.isValid() ? std::vector{rate.toInt()} : allRates;
    const auto [first, last] = std::minmax({m_first->value(), m_last->value()});
    wish.first = {static_cast<std::uint8_t>(first)};
    wish.last = {static_cast<std::uint8_t>(last)};
    wish.throughMaster = m_master->isChecked();
    return wish;
}

void EscLineSearch::setSettings(const ScanWish &wish)
{
    m_first->setValue(wish.first.value);
    m_last->setValue(wish.last.value);
    m_master->setChecked(wish.throughMaster);
    if (wish.baudRates.size() > 1) {
        m_rates->setCurrentIndex(m_rates->count() - 1);
        return;
    }
    const int rate = wish.baudRates.front();
    if (m_rates->findData(rate) < 0)
        m_rates->insertItem(0, sentence(tr("%1 Bd"), {QString::number(rate)}), rate);
    m_rates->setCurrentIndex(m_rates->findData(rate));
}

bool EscLineSearch::isConnected() const
{
    return m_line && m_line->isOpen() && m_line->latest().connected;
}

void EscLineSearch::start()
{
    m_message->withdraw();
    if (const QString wrong = takeFields(*this); !wrong.isEmpty()) {
        m_message->showMessage(Role::attention, wrong);
        return;
    }
    m_found->clear();
    m_empty->setTexts(tr("Searching"),
                      tr("Each address is asked for its serial number. Nothing is written."));
    m_content->setCurrentWidget(m_empty);
    m_isSearching = true;
    m_progress->setRange(0, 0);
    m_progress->show();
    m_line->scan(wish());
    showWhatIsPossible();
}

void EscLineSearch::showProgress(const ScanProgress &progress)
{
    m_isSearching = true;
    m_progress->show();
    m_progress->setRange(0, progress.total);
    m_progress->setValue(progress.asked);
    m_progress->setFormat(tr("%1 of %2 asked").arg(progress.asked).arg(progress.total));
    showFound(progress.found);
    if (!progress.found.empty())
        m_content->setCurrentWidget(m_table);
    showWhatIsPossible();
}

void EscLineSearch::showEnd(const ScanEnded &ended)
{
    m_isSearching = false;
    m_progress->hide();
    showFound(ended.found);
    const QString requests = tr("Requests sent: %n.", nullptr, ended.requests);
    if (!ended.found.empty()) {
        m_content->setCurrentWidget(m_table);
        const QString found = tr("Encoders found: %n.", nullptr, static_cast<int>(ended.found.size()));
        m_message->showMessage(ended.cancelled ? Role::attention : Role::running,
                               ended.cancelled ? tr("The search was cancelled.") + u' ' + found : found);
    } else {
        m_content->setCurrentWidget(m_empty);
        m_empty->setTexts(ended.cancelled ? tr("The search was cancelled") : tr("No encoder has answered"),
                          requests + u' ' +
                              tr("Check: the address and the baud rate (search all three); the wiring, both "
                                 "pairs the right way "
                                 "round, termination; the supply of the encoder; with RS-422 that the input "
                                 "ST (pin 7) is tied "
                                 "to +UB, without it no command works."));
    }
    showWhatIsPossible();
}

// The kind whose interface the encoders tell in their version: "RS-485" in "5882 RS485 V1.2".
void EscLineSearch::proposeKind(const std::vector<FoundEncoder> &found)
{
    for (int i = 0; i < m_device->count() && !found.empty(); ++i) {
        const QString last = lettersAndDigits(m_device->itemText(i).section(u' ', -1));
        if (!last.isEmpty() && lettersAndDigits(found.front().version).contains(last)) {
            m_device->setCurrentIndex(i);
            return;
        }
    }
}

void EscLineSearch::showFound(const std::vector<FoundEncoder> &found)
{
    m_found->show(found);
    proposeKind(found);
    m_table->resizeColumnToContents(FoundEncoderModel::address);
}

void EscLineSearch::showFoundBefore(const std::vector<FoundEncoder> &found)
{
    if (found.empty() || m_isSearching)
        return;
    m_found->clear();
    showFound(found);
    m_content->setCurrentWidget(m_table);
    m_message->showMessage(Role::running, tr("Encoders found: %n.", nullptr, static_cast<int>(found.size())));
    showWhatIsPossible();
}

void EscLineSearch::showLeft(const std::vector<FoundEncoder> &left)
{
    if (left.empty() || !m_line)
        return;
    QStringList named;
    for (const FoundEncoder &encoder : left)
        named << tr("%1 at %2 Bd").arg(encoder.address.shown(), QString::number(encoder.baudRate));
    m_message->showMessage(
        Role::attention,
        sentence(tr("Not taken over: %1. The line runs at %2 Bd. Choose the other baud rate in the settings "
                    "of the line, and connect it again."),
                 {named.join(QStringLiteral(", ")), QString::number(m_line->settings().baudRate)}));
}

void EscLineSearch::showRefused(const Refusal &why)
{
    m_message->showMessage(Role::attention, refusalText(why));
}

void EscLineSearch::showWhatIsPossible()
{
    const bool isConnectedNow = isConnected();
    for (QWidget *field : std::initializer_list<QWidget *>{m_first, m_last, m_rates, m_master})
        field->setEnabled(!m_isSearching);
    m_start->setEnabled(isConnectedNow && !m_isSearching);
    m_start->setToolTip(isConnectedNow ? tr("Asks one address after the other (Alt+S)")
                                       : tr("The serial line is not open. Connect it first."));
    m_cancel->setEnabled(m_isSearching);
    m_take->setEnabled(!m_isSearching && !m_found->chosen().empty());
}

} // namespace codewheel
