// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/settings/settings_dialog.h"

#include "journal/ledger_writer.h"
#include "widgets/help/help_topic.h"
#include "widgets/input/number_fields.h"
#include "widgets/look/content_scroll_area.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/label_text.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTabWidget>

namespace codewheel {
namespace {

constexpr int charactersInLine = 68;
constexpr int linesHigh = 34; // the height of a page at most; it scrolls in a smaller window

// A sentence below its field.
QLabel *sentence(const QString &text, QWidget *parent)
{
    QLabel *label = wrappedLabel(parent);
    label->setText(text);
    label->setFont(textFont(TextSize::small));
    label->setTextFormat(Qt::PlainText);
    return label;
}

} // namespace

SettingsDialog::SettingsDialog(const ProgramSettings &settings, const std::vector<KeptFolder> &folders,
                               QWidget *parent)
    : QDialog(parent, Qt::Tool)
    , m_settings(settings)
    , m_pages(new QTabWidget(this))
{
    setHelpTopic(*this, "settings.md");
    setObjectName(QStringLiteral("settings"));
    setWindowTitle(tr("Settings"));
    makeLook();
    makeWarnings();
    makeKept(folders);
    makeNotices();
    layOutColumn(this, {{m_pages, 1}}, {.spacing = grid::margin, .margins = allAround(grid::margin)});
    makeButtons();
    resize(minimumSizeHint().expandedTo(
        {charactersInLine * fontMetrics().averageCharWidth(), linesHigh * fontMetrics().height()}));
    showValues(settings);
    m_isShowing = false;
}

QFormLayout *SettingsDialog::addPage(const QString &title)
{
    auto *page = new QWidget(m_pages);
    auto *form = makeForm(page, grid::unit, grid::margin);
    m_pages->addTab(new ContentScrollArea(page, m_pages), title);
    return form;
}

QComboBox *SettingsDialog::addChoice(QFormLayout &form, const QString &label, const QString &what)
{
    auto *box = describe(new QComboBox(form.parentWidget()), plainLabel(label), what);
    form.addRow(label, box);
    form.addRow(QString(), sentence(what, form.parentWidget()));
    connect(box, &QComboBox::currentIndexChanged, this, &SettingsDialog::take);
    return box;
}

QCheckBox *SettingsDialog::addSwitch(QFormLayout &form, const char *id, const QString &label,
                                     const QString &what)
{
    auto *box = describe(new QCheckBox(label, form.parentWidget()), id, what);
    form.addRow(QString(), box);
    form.addRow(QString(), sentence(what, form.parentWidget()));
    connect(box, &QCheckBox::toggled, this, &SettingsDialog::take);
    return box;
}

QSpinBox *SettingsDialog::addNumber(QFormLayout &form, const QString &label, const QString &unit,
                                    const QString &what, SettingRange range)
{
    auto *field = describe(new IntegerField(form.parentWidget()), plainLabel(label), what);
    field->setRange(range.least, range.most);
    field->setSuffix(unit);
    form.addRow(label, field);
    form.addRow(QString(), sentence(what, form.parentWidget()));
    connect(field, &QSpinBox::valueChanged, this, &SettingsDialog::take);
    return field;
}

QLineEdit *SettingsDialog::addText(QFormLayout &form, const QString &label, const QString &what, int longest)
{
    auto *field = describe(new QLineEdit(form.parentWidget()), plainLabel(label), what);
    field->setMaxLength(longest);
    form.addRow(label, field);
    form.addRow(QString(), sentence(what, form.parentWidget()));
    connect(field, &QLineEdit::textChanged, this, &SettingsDialog::take);
    return field;
}

void SettingsDialog::makeLook()
{
    QFormLayout &form = *addPage(tr("Language and appearance"));
    m_language =
        addChoice(form, tr("&Language"), tr("Of all texts. The window is rebuilt; the buses keep running."));
    m_language->setObjectName(QStringLiteral("settingsLanguage"));
    m_language->addItem(tr("Same as the system"), QString());
    m_language->addItem(QStringLiteral("English"), QStringLiteral("en"));
    m_language->addItem(QStringLiteral("Deutsch"), QStringLiteral("de"));
    m_decimalSign = addChoice(
        form, tr("&Numbers"),
        tr("The sign before decimals. The other one may be typed too, but not before three digits."));
    m_decimalSign->setObjectName(QStringLiteral("settingsNumbers"));
    m_decimalSign->addItem(tr("As usual in the language"), static_cast<int>(DecimalSign::ofLanguage));
    m_decimalSign->addItem(tr("Decimal point: 0.25"), static_cast<int>(DecimalSign::point));
    m_decimalSign->addItem(tr("Decimal comma: 0,25"), static_cast<int>(DecimalSign::comma));
    m_scheme = addChoice(form, tr("&Theme"), tr("Light or dark, or as the desktop is."));
    m_scheme->setObjectName(QStringLiteral("settingsTheme"));
    m_scheme->addItem(tr("Same as the system"), static_cast<int>(Scheme::system));
    m_scheme->addItem(tr("Light"), static_cast<int>(Scheme::light));
    m_scheme->addItem(tr("Dark"), static_cast<int>(Scheme::dark));
    m_largeControls = addSwitch(form, "settingsLargeControls", tr("Large &controls"),
                                tr("Bits and buttons are 1.5 times as large, for gloves."));
    m_lessMotion = addSwitch(form, "settingsLessMotion", tr("Less &motion"),
                             tr("Panels are not animated. Values always change at once."));
    m_frames = addChoice(form, tr("&Frames a second"),
                         tr("How often values are painted. Fewer spare the processor; the bus is not slower, "
                            "and no change of a bit is lost."));
    m_frames->setObjectName(QStringLiteral("settingsFrames"));
    for (const int rate : frameRates)
        m_frames->addItem(QString::number(rate), rate);
}

void SettingsDialog::makeWarnings()
{
    QFormLayout &form = *addPage(tr("EEPROM"));
    m_eeprom = addNumber(form, tr("&Ask from"), tr(" %", "percent of the writes the manual speaks of"),
                         tr("From this share of the writes stated in an encoder's manual, each write has to "
                            "be confirmed. It cannot be above the usual 75 %. Beyond what the manual "
                            "guarantees, the place always has to be typed."),
                         eepromQuestionRange);
    m_eeprom->setObjectName(QStringLiteral("settingsEeprom"));
    m_userName = addText(form, tr("Your &name"),
                         tr("Entered with each EEPROM write, beside the name of this computer, in the window "
                            "and on the command line. May stay empty."),
                         longestUserName);
    m_userName->setObjectName(QStringLiteral("settingsUserName"));
}

void SettingsDialog::makeKept(const std::vector<KeptFolder> &folders)
{
    QFormLayout &form = *addPage(tr("Files"));
    m_messageFile =
        addNumber(form, tr("&Messages, at most"), tr(" MB", "megabytes"),
                  tr("Beyond this, the oldest messages are dropped. Takes effect at the next start."),
                  messageFileRange);
    m_traceRows =
        addNumber(form, tr("&Handshake trace and terminal, at most"), tr(" rows", "of a table"),
                  tr("Kept for each encoder, and in the terminal of each serial line, while the program "
                     "runs; the oldest are dropped."),
                  traceRowsRange);
    m_trendMemory =
        addNumber(form, tr("&Trend, at most"), tr(" MB", "megabytes"),
                  tr("Memory for what all encoders have shown while the program runs; the oldest is "
                     "dropped. How far back it goes is shown on the page of the trend."),
                  trendMemoryRange);
    m_keeping = addNumber(form, tr("&Unsaved changes, every"), tr(" s", "seconds"),
                          tr("How often unsaved changes are kept in case of a crash. They are offered at the "
                             "next start until they are recovered or discarded."),
                          keepingRange);
    m_messageFile->setObjectName(QStringLiteral("settingsMessageFile"));
    m_traceRows->setObjectName(QStringLiteral("settingsTraceRows"));
    m_trendMemory->setObjectName(QStringLiteral("settingsTrendMemory"));
    m_keeping->setObjectName(QStringLiteral("settingsKeeping"));
    form.addRow(new FolderRows(folders, form.parentWidget()));
    form.addRow(
        sentence(tr("The folders follow XDG_CONFIG_HOME and XDG_DATA_HOME of the system, so that window "
                    "and command line share one account of EEPROM writes; they are not changed here."),
                 form.parentWidget()));
}

void SettingsDialog::makeNotices()
{
    QFormLayout &form = *addPage(tr("Faults"));
    m_notices = addSwitch(form, "settingsNotices", tr("&Notify of faults while another program is in front"),
                          tr("A notice on the desktop says what has failed and where. Several in a short "
                             "time are put together."));
    m_noticeSound = addSwitch(form, "settingsNoticeSound", tr("With a &sound"),
                              tr("The desktop plays its sound for errors; where it has none, the program "
                                 "beeps."));
    connect(m_notices, &QCheckBox::toggled, m_noticeSound, &QWidget::setEnabled);
}

void SettingsDialog::makeButtons()
{
    auto *buttons = new QDialogButtonBox(
        QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults, this);
    buttons->button(QDialogButtonBox::Ok)->setToolTip(tr("Keeps what is set"));
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Restores what was set before (Esc)"));
    buttons->button(QDialogButtonBox::RestoreDefaults)
        ->setToolTip(tr("Sets everything as it is after installation; Cancel undoes that"));
    layout()->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &SettingsDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &SettingsDialog::reject);
    connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, [this] {
        showValues({});
        take();
    });
}

void SettingsDialog::setSettings(const ProgramSettings &settings)
{
    m_settings = settings;
    showValues(settings);
}

int SettingsDialog::page() const
{
    return m_pages->currentIndex();
}

void SettingsDialog::setPage(int page)
{
    m_pages->setCurrentIndex(page);
}

// What is being typed counts; if refused, it stays to be corrected.
void SettingsDialog::accept()
{
    if (takeFields(*this).isEmpty())
        QDialog::accept();
}

void SettingsDialog::showValues(const ProgramSettings &settings)
{
    const QScopedValueRollback showing(m_isShowing, true);
    const auto choose = [](QComboBox &box, const QVariant &value) {
        box.setCurrentIndex(std::max(0, box.findData(value)));
    };
    choose(*m_language, settings.language);
    choose(*m_decimalSign, static_cast<int>(settings.decimalSign));
    choose(*m_scheme, static_cast<int>(settings.appearance.scheme));
    m_largeControls->setChecked(settings.appearance.largeControls);
    m_lessMotion->setChecked(settings.appearance.lessMotion);
    choose(*m_frames, settings.framesPerSecond);
    m_eeprom->setValue(settings.eepromQuestionFrom);
    m_userName->setText(settings.userName);
    m_messageFile->setValue(settings.largestMessageFile);
    m_traceRows->setValue(settings.traceRows);
    m_trendMemory->setValue(settings.trendMemory);
    m_keeping->setValue(settings.secondsBetweenKeeping);
    m_notices->setChecked(settings.notifiesOfFaults);
    m_noticeSound->setChecked(settings.notifiesWithSound);
    m_noticeSound->setEnabled(settings.notifiesOfFaults);
}

void SettingsDialog::take()
{
    if (m_isShowing)
        return;
    const ProgramSettings taken{
        .language = m_language->currentData().toString(),
        .appearance = {.scheme = static_cast<Scheme>(m_scheme->currentData().toInt()),
                       .largeControls = m_largeControls->isChecked(),
                       .lessMotion = m_lessMotion->isChecked()},
        .decimalSign = static_cast<DecimalSign>(m_decimalSign->currentData().toInt()),
        .framesPerSecond = m_frames->currentData().toInt(),
        .eepromQuestionFrom = m_eeprom->value(),
        .userName = m_userName->text(),
        .largestMessageFile = m_messageFile->value(),
        .traceRows = m_traceRows->value(),
        .trendMemory = m_trendMemory->value(),
        .secondsBetweenKeeping = m_keeping->value(),
        .notifiesOfFaults = m_notices->isChecked(),
        .notifiesWithSound = m_noticeSound->isChecked(),
    };
    if (taken == m_settings)
        return;
    m_settings = taken;
    Q_EMIT changed(taken);
}

} // namespace codewheel
