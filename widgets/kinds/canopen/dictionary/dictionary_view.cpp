// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/dictionary/dictionary_view.h"

#include "kinds/canopen/bus/canopen_bus_refusals.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/eds/standard_objects.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/kinds/canopen/dictionary/heard_values.h"
#include "widgets/kinds/canopen/dictionary/object_filter.h"
#include "widgets/kinds/canopen/dictionary/object_texts.h"
#include "widgets/kinds/canopen/dictionary/object_transfers.h"
#include "widgets/kinds/canopen/dictionary/object_write_bar.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/log_table.h"
#include "widgets/look/may_elide.h"
#include "widgets/look/tool.h"

#include <QAction>
#include <QComboBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QStackedWidget>
#include <QToolBar>

#include <algorithm>

namespace codewheel {

namespace {

constexpr int fewestMeaningLettersOfObject = 16;
constexpr int shownNameLetters = 24;

} // namespace

DictionaryView::DictionaryView(QWidget *parent)
    : QWidget(parent)
    , m_rows(new ObjectModel(this))
    , m_filter(new ObjectFilter(*m_rows, this))
    , m_transfers(new ObjectTransfers(this))
    , m_heard(new HeardValues(this))
    , m_table(new LogTable(tr("Objects of the node"), this))
    , m_content(new QStackedWidget(this))
    , m_source(new QLabel(this))
    , m_counts(new QLabel(this))
    , m_message(new InlineMessage(this))
    , m_writing(new ObjectWriteBar(*m_transfers, this))
{
    setAccessibleName(tr("Objects"));
    auto *tools = new QToolBar(tr("Objects"), this);
    makeTools(*tools);
    makeTable();
    m_content->addWidget(m_table);
    m_content->addWidget(new EmptyState(
        Icon::list, tr("No encoder on a CAN bus is chosen"),
        tr("Choose one in the bus structure: its objects are listed here, to be read and written."), this));
    m_content->setMinimumHeight(4 * grid::largeIcon);
    named(m_message, "objectsMessage");
    auto *column = layOut<QVBoxLayout>(this, grid::unit, QMargins(grid::unit, 0, grid::unit, grid::unit));
    column->addWidget(tools);
    column->addWidget(makeFilter());
    column->addWidget(m_content, 1);
    column->addWidget(m_message);
    column->addWidget(m_writing);
    setFocusProxy(m_table);
    connect(m_transfers, &ObjectTransfers::ended, this, &DictionaryView::takeEnd);
    connect(m_transfers, &ObjectTransfers::refused, this,
            [this](const Refusal &why) { m_message->showMessage(Role::attention, refusalText(why)); });
    connect(m_writing, &ObjectWriteBar::begun, m_message, &InlineMessage::withdraw);
    connect(m_heard, &HeardValues::written, m_writing, &ObjectWriteBar::takeWrittenByOther);
    connect(m_heard, &HeardValues::identityTold, this, &DictionaryView::showDoubt);
    connect(m_transfers, &ObjectTransfers::changed, this, &DictionaryView::showProgress);
    showRows();
}

DictionaryView::~DictionaryView()
{
    const QSignalBlocker silent(m_table); // receivers may be gone by now
    m_table->setModel(nullptr);
}

void DictionaryView::makeTools(QToolBar &bar)
{
    setUpToolBar(bar);
    m_open = addTool(
        *this, bar,
        {Icon::open, tr("Open EDS…"), {}, tr("The objects as a file of the maker has them (EDS, DCF)")});
    m_drop = addTool(*this, bar,
                     {Icon::remove, tr("Drop EDS"), QKeySequence(Qt::CTRL | Qt::Key_Delete),
                      tr("The objects as without a file; what was read stays")});
    m_read = addTool(*this, bar, {Icon::read, tr("Read"), {}, {}});
    m_readAll = addTool(*this, bar, {Icon::refresh, tr("Read all"), {}, {}});
    m_cancel = addTool(*this, bar, {Icon::cancel, tr("Cancel"), {}, tr("Leaves the other objects unread")});
    m_compare = addTool(*this, bar,
                        {Icon::compare, tr("Compare…"), {}, tr("Marks what an EDS or DCF has otherwise")});
    m_onlyDifferent = addTool(
        *this, bar,
        {Icon::filter,
         tr("Differences"),
         {},
         tr("Shows only what the node has otherwise than its file, the project or the file compared with")});
    m_export = addTool(*this, bar, {Icon::exportData, tr("Export…"), {}, tr("Saves the values as a DCF")});
    m_onlyDifferent->setCheckable(true);
    connect(m_open, &QAction::triggered, this, &DictionaryView::askOpen);
    connect(m_drop, &QAction::triggered, this, &DictionaryView::dropFile);
    connect(m_read, &QAction::triggered, this, &DictionaryView::readChosen);
    connect(m_readAll, &QAction::triggered, this, &DictionaryView::readListed);
    connect(m_cancel, &QAction::triggered, m_transfers, &ObjectTransfers::cancel);
    connect(m_compare, &QAction::triggered, this, &DictionaryView::askCompare);
    connect(m_export, &QAction::triggered, this, &DictionaryView::askExport);
    connect(m_onlyDifferent, &QAction::toggled, this, [this](bool only) {
        m_filter->setOnlyDifferent(only);
        showCounts();
        if (only)
            tellProject();
    });
}

void DictionaryView::makeTable()
{
    using Column = ObjectModel::Column;
    m_table->setModel(m_filter);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    const QFontMetrics numbers(numberFont());
    const int gap = 2 * grid::margin;
    const auto setWidth = [&](Column column, const QFontMetrics &metrics, const QString &widest) {
        m_table->setColumnWidth(column, metrics.horizontalAdvance(widest) + gap);
    };
    const QString widestValue = QStringLiteral("00000000h = 0000000000");
    setWidth(Column::object, numbers, QStringLiteral("6004h:00"));
    setWidth(Column::name, fontMetrics(), QString(shownNameLetters, u'n'));
    setWidth(Column::type, fontMetrics(), QStringLiteral("unicode"));
    setWidth(Column::access, fontMetrics(), objectAccessText(canopen::FileAccess::readAndWrite));
    setWidth(Column::factory, numbers, widestValue);
    setWidth(Column::inFile, numbers, widestValue);
    setWidth(Column::value, numbers, widestValue + u'0');
    setWidth(Column::project, numbers, widestValue + u'0');
    setWidth(Column::other, numbers, widestValue);
    setWidth(Column::readAt, numbers,
             sentence(ObjectModel::tr("heard, at %1"), {QStringLiteral("00:00:00")}));
    for (const Column column : {Column::name, Column::type, Column::access, Column::factory, Column::inFile,
                                Column::value, Column::project, Column::other})
        allowEliding(*m_table, column);
    m_table->setTextColumn(Column::meaning, fewestMeaningLettersOfObject);
    showComparedColumns();
    connect(m_table, &LogTable::chosenChanged, this, &DictionaryView::showChosen);
}

QWidget *DictionaryView::makeFilter()
{
    auto *filter = new QWidget(this);
    m_group = describe(new QComboBox(filter), "objectGroup", tr("Objects to show"),
                       tr("Which objects are listed, and read by Read all"));
    m_group->addItem(tr("All objects"));
    m_group->addItem(tr("Communication (1000h)"));
    m_group->addItem(tr("Maker (2000h)"));
    m_group->addItem(tr("Profile (6000h)"));
    auto *text = describe(new QLineEdit(filter), "objectText", tr("Filter by text"),
                          tr("Shows only objects with this in them: 6004h, cam, a value"));
    text->setPlaceholderText(tr("Object, name or value"));
    text->setClearButtonEnabled(true);
    connect(m_group, &QComboBox::currentIndexChanged, this, [this](int group) {
        m_filter->setGroup(static_cast<ObjectFilter::Group>(group));
        showCounts();
    });
    connect(text, &QLineEdit::textChanged, this, [this](const QString &typed) {
        m_filter->setText(typed);
        showCounts();
    });
    auto *row = layOut<QHBoxLayout>(filter, grid::groupGap);
    row->addWidget(m_group);
    row->addWidget(text, 1);
    row->addWidget(m_source);
    row->addWidget(m_counts);
    return filter;
}

void DictionaryView::setBus(CanopenSession *bus)
{
    if (m_bus)
        m_bus->disconnect(this);
    const bool isOther = m_bus != bus;
    m_bus = bus;
    if (isOther && bus != nullptr) // what was read is of other devices
        for (auto &[node, its] : m_known)
            its.rows.clear();
    m_transfers->setBus(bus);
    m_heard->setBus(bus);
    if (bus != nullptr) {
        connect(bus, &CanopenSession::stateChanged, this, &DictionaryView::showWhatIsPossible);
        connect(bus, &CanopenSession::nodesChanged, this, &DictionaryView::followDescription);
        connect(bus, &CanopenSession::updated, this, &DictionaryView::takeHeard);
        connect(bus, &QObject::destroyed, this, &DictionaryView::showWhatIsPossible);
    }
    if (isOther && bus != nullptr)
        showRows();
    else
        showWhatIsPossible();
}

void DictionaryView::setNode(std::optional<int> node)
{
    if (node == m_node)
        return;
    keepRows();
    m_transfers->setNode(node);
    m_heard->setNode(node);
    m_node = node;
    m_message->withdraw();
    if (node)
        if (const auto before = m_known.find(*node); before != m_known.end())
            before->second.whyNot.clear(); // its file may be there again
    showRows();
}

void DictionaryView::setPlanned(PlannedObjects planned)
{
    if (m_planned == planned)
        return;
    m_planned = std::move(planned);
    for (const auto &[node, path] : m_planned.files) {
        const auto found = m_known.find(node);
        if (found != m_known.end() && found->second.path != path)
            found->second = {.path = path,
                             .rows = std::move(found->second.rows),
                             .comparedWith = std::move(found->second.comparedWith),
                             .comparedPath = std::move(found->second.comparedPath)};
    }
    if (m_node)
        renewRows();
}

const std::vector<canopen::WantedObject> &DictionaryView::wanted() const
{
    static const std::vector<canopen::WantedObject> none;
    const auto found = m_node ? m_planned.wanted.find(*m_node) : m_planned.wanted.end();
    return found != m_planned.wanted.end() ? found->second : none;
}

void DictionaryView::setRecordingChosen(bool isChosen)
{
    m_isRecordingChosen = isChosen;
    showWhatIsPossible();
}

DictionaryView::Known &DictionaryView::known()
{
    const auto [found, isNew] = m_known.try_emplace(m_node.value_or(0));
    Known &its = found->second;
    if (isNew)
        if (const auto planned = m_planned.files.find(found->first); planned != m_planned.files.end())
            its.path = planned->second;
    if (!its.path.isEmpty() && !its.isRead && its.whyNot.isEmpty())
        readKnownFile(its);
    if (!its.isRead && its.file.objects.empty())
        describeKnown(its);
    return its;
}

void DictionaryView::describeKnown(Known &its) const
{
    const DeviceDescription *device = description();
    its.file = canopen::describedObjects(device);
    its.deviceKey = device != nullptr ? device->key : QString();
}

const DeviceDescription *DictionaryView::description() const
{
    const EncoderSession *encoder =
        m_bus && m_node ? m_bus->encoder(m_bus->placeOf(CanopenAddress{*m_node}.place())) : nullptr;
    return encoder != nullptr ? &encoder->device() : nullptr;
}

// By now it may be known of which make the encoder is.
void DictionaryView::followDescription()
{
    if (m_node && isDescribedAnew())
        renewRows();
}

bool DictionaryView::isDescribedAnew()
{
    const DeviceDescription *device = description();
    return device != nullptr && !known().isRead && known().deviceKey != device->key;
}

void DictionaryView::keepRows()
{
    if (m_node)
        known().rows = m_rows->rows();
}

// Their rows may be others since: another file is compared with, the project wants more.
void DictionaryView::showRows()
{
    std::vector<ObjectRow> rows;
    if (m_node) {
        Known &its = known();
        if (isDescribedAnew())
            describeKnown(its);
        rows = objectRows(its.file, its.comparedWith ? &*its.comparedWith : nullptr, wanted());
        takeAnswers(rows, its.rows);
    }
    m_rows->show(std::move(rows), m_node);
    m_rows->setWanted(wanted());
    m_content->setCurrentIndex(m_node ? 0 : 1);
    showComparedColumns();
    showSource();
    showDoubt();
    showChosen();
    showProgress();
}

// The chosen object stays chosen.
void DictionaryView::renewRows()
{
    const auto chosen = chosenObject();
    keepRows();
    showRows();
    const int row = chosen ? m_rows->rowOf(chosen->object) : -1;
    if (row >= 0)
        m_table->setCurrentIndex(m_filter->mapFromSource(m_rows->index(row, 0)));
}

void DictionaryView::showComparedColumns()
{
    const bool hasFileValues =
        m_node && std::ranges::any_of(known().file.objects,
                                      [](const canopen::FileObject &each) { return each.value.has_value(); });
    m_table->setColumnHidden(ObjectModel::inFile, !hasFileValues);
    m_table->setColumnHidden(ObjectModel::project, wanted().empty());
    m_table->setColumnHidden(ObjectModel::other, !m_node || !known().comparedWith);
}

bool DictionaryView::canDiffer()
{
    return !m_table->isColumnHidden(ObjectModel::inFile) || !m_table->isColumnHidden(ObjectModel::project) ||
           !m_table->isColumnHidden(ObjectModel::other);
}

void DictionaryView::showSource()
{
    if (!m_node) {
        m_source->clear();
        return;
    }
    const Known &its = known();
    const QString standards = tr("CiA 301 and CiA 406");
    const QString manyTip =
        tr("No device has all of these objects. A file of the maker has those of the device");
    if (its.isRead) {
        m_source->setText(QFileInfo(its.path).fileName());
        m_source->setToolTip(its.path);
    } else if (const DeviceDescription *device = description(); device != nullptr && !device->isGeneric()) {
        m_source->setText(device->fullName());
        m_source->setToolTip(sentence(tr("%1, and what the description has: %2"), {standards, manyTip}));
    } else {
        m_source->setText(standards);
        m_source->setToolTip(manyTip);
    }
}

void DictionaryView::showCounts()
{
    const int shown = m_filter->rowCount();
    const int inOneOnly = m_onlyDifferent->isChecked() ? m_filter->inOneFileOnly() : 0;
    const QString all = QString::number(m_rows->rowCount());
    m_counts->setText(
        m_transfers->isBusy() && m_reading > 1
            ? sentence(tr("%1 of %2 read"),
                       {QString::number(m_reading - m_transfers->left() - 1), QString::number(m_reading)})
        : inOneOnly > 0 ? sentence(tr("%1 differ, then %2 that are not in both, of %3"),
                                   {QString::number(shown - inOneOnly), QString::number(inOneOnly), all})
                        : sentence(tr("%1 of %2"), {QString::number(shown), all}));
}

void DictionaryView::showProgress()
{
    if (!m_transfers->isBusy()) {
        m_reading = 0;
        if (m_node && known().comparedWith)
            compareAgain();
    }
    showCounts();
    showWhatIsPossible();
}

std::optional<canopen::FileObject> DictionaryView::chosenObject() const
{
    const QModelIndex chosen = m_filter->mapToSource(m_table->currentIndex());
    return chosen.isValid() ? std::optional(m_rows->rowAt(chosen.row()).object) : std::nullopt;
}

void DictionaryView::showChosen()
{
    auto object = chosenObject();
    if (object && m_rows->rowAt(m_rows->rowOf(object->object)).source != ObjectRow::Source::file)
        object->access.reset(); // what another file says of it is not said of this node
    m_writing->setObject(object, m_node);
    showWhatIsPossible();
}

QString DictionaryView::whyNotSent() const
{
    if (m_isRecordingChosen)
        return refusalText({RefusalKind::notSupported, RefusalId::onlyRecorded, {}});
    if (!m_bus || !m_bus->isOpen() || !m_bus->latest().connected)
        return refusalText({RefusalKind::link, CanopenBusRefusalId::closed, {}});
    if (!m_bus->isOperating())
        return refusalText({RefusalKind::busy, RefusalId::watchOnly, {m_bus->linkName()}});
    return m_node ? QString() : tr("Choose an encoder of the CAN bus first");
}

void DictionaryView::showWhatIsPossible()
{
    const QString whyNot = whyNotSent();
    const bool isBusy = m_transfers->isBusy();
    const auto object = chosenObject();
    const bool isReadable = object && object->access != canopen::FileAccess::writeOnly;
    const auto tell = [&](QAction *action, bool isPossible, const QString &tip) {
        action->setEnabled(isPossible && whyNot.isEmpty() && !isBusy);
        action->setToolTip(whyNot.isEmpty() ? tip : whyNot);
    };
    tell(m_read, isReadable,
         !object       ? tr("Choose an object of the table first")
         : !isReadable ? tr("This object can only be written")
                       : tr("Asks the node for the chosen object"));
    tell(m_readAll, m_filter->rowCount() > 0,
         tr("Asks the node for each object that is listed, one after the other; for none that can only be "
            "written"));
    m_cancel->setEnabled(m_transfers->left() > 0);
    for (QAction *action : {m_open, m_compare, m_export})
        action->setEnabled(m_node && !isBusy);
    m_drop->setEnabled(m_node && !isBusy && !known().path.isEmpty());
    m_onlyDifferent->setEnabled(canDiffer());
    if (!m_onlyDifferent->isEnabled())
        m_onlyDifferent->setChecked(false);
    m_writing->setWhyNot(whyNot);
}

void DictionaryView::readChosen()
{
    if (const auto object = chosenObject())
        beginReading({object->object});
}

void DictionaryView::readListed()
{
    std::vector<canopen::SdoObject> objects;
    for (int row = 0; row < m_filter->rowCount(); ++row) {
        const canopen::FileObject &object =
            m_rows->rowAt(m_filter->mapToSource(m_filter->index(row, 0)).row()).object;
        if (object.access != canopen::FileAccess::writeOnly)
            objects.push_back(object.object);
    }
    beginReading(objects);
}

void DictionaryView::beginReading(const std::vector<canopen::SdoObject> &objects)
{
    m_message->withdraw();
    if (!whyNotSent().isEmpty() || m_transfers->isBusy())
        return;
    m_reading = objects.size();
    m_transfers->read(objects);
}

void DictionaryView::takeEnd(const canopen::SdoRequest &request, const canopen::SdoOutcome &outcome)
{
    const bool isUnknown = outcome.kind == canopen::SdoOutcome::Kind::noAnswer;
    if ((!request.value || isUnknown) && m_bus) // behind a write, the value of before tells nothing
        m_rows->take(request.object, outcome, m_bus->dateTime(m_bus->now()).toLocalTime().time());
    const bool isNotSent = outcome.kind == canopen::SdoOutcome::Kind::notSent;
    if (isNotSent || (isUnknown && !request.value))
        m_message->showMessage(
            Role::attention,
            refusalText({RefusalKind::link,
                         isNotSent ? CanopenRefusalId::sdoNotSent : CanopenRefusalId::sdoNoAnswer,
                         {request.object.text(), std::int64_t{request.node}}}));
}

// As often as a picture; a view that nobody sees catches up.
void DictionaryView::takeHeard()
{
    if (!m_node || !m_bus || !isVisible())
        return;
    bool isTransferred = false;
    for (const canopen::HeardObject &heard : m_heard->takeNews()) {
        m_rows->hear(heard.object, heard.value, m_bus->dateTime(heard.at).toLocalTime().time());
        isTransferred |= heard.how != canopen::HeardObject::How::sent;
    }
    if (isTransferred && known().comparedWith)
        compareAgain();
}

} // namespace codewheel
