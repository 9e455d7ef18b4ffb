// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/program.h"

#include "app/journal_files.h"
#include "app/user_devices.h"
#include "app/window/main_window.h"
#include "app/window/plant.h"
#include "app/window/project_files.h"
#include "app/window/project_recovery.h"
#include "app/window/start_probe.h"
#include "widgets/messages/message_model.h"

#include <QApplication>
#include <QFileInfo>
#include <QStandardPaths>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr auto measuredRun = 2s; // then a measured start ends

} // namespace

Program::Program(QApplication &application, const QString &settingsFile)
    : m_application(application)
    , m_dataFolder(settingsFile.isEmpty() ? userJournalFolder() : QFileInfo(settingsFile).absolutePath())
    , m_settings(settingsFile)
    , m_recoveryFolder((settingsFile.isEmpty()
                            ? QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)
                            : QFileInfo(settingsFile).path()) +
                       QStringLiteral("/recovery"))
{
    applyAppearance(application, m_settings.appearance());
    m_language.use(m_settings.language());
}

Program::~Program()
{
    m_pictures.stop();
    m_window.reset(); // before the sessions it looks at
}

int Program::run()
{
    openWindow();
    m_window->show();
    return QApplication::exec();
}

// Nothing but the window is made before it is seen; the bus comes after.
void Program::openWindow()
{
    m_window = std::make_unique<MainWindow>(m_settings, m_project);
    m_pictures.setWindow(*m_window);
    connect(m_window.get(), &MainWindow::languageChosen, this, &Program::useLanguage, Qt::QueuedConnection);
    if (m_plant) {
        attach();
        m_window->askForRecovery(*m_recovery);
    } else
        connect(m_window.get(), &MainWindow::firstPainted, this, &Program::startBus);
}

void Program::startBus()
{
    const bool measured = reportFirstPaint();
    m_catalog = std::make_unique<Catalog>(Catalog::builtIn());
    const std::vector<Catalog::Fault> faults = addUserDevices(*m_catalog, userDeviceFolder());
    m_store = std::make_unique<MessageStore>(MessageStore::Settings{
        .file = messageFile(m_dataFolder), .largestSize = m_settings.largestMessageFile()});
    m_messages = std::make_unique<MessageModel>(*m_store);
    m_plant = std::make_unique<Plant>(BusAtWork::Surroundings{
        .catalog = *m_catalog, .project = m_project, .dataFolder = m_dataFolder, .clock = [] {
            return QDateTime::currentDateTime();
        }});
    connect(m_plant.get(), &Plant::messaged, m_messages.get(), &MessageModel::add);
    m_plant->openTraining();
    for (const Catalog::Fault &fault : faults)
        m_messages->addNow(
            {.severity = Severity::attention,
             .refusal =
                 Refusal{RefusalKind::badInput, RefusalId::deviceFileBroken, {fault.place(), fault.reason}}});
    attach();
    openProject();
    m_plant->start();
    m_pictures.start();
    if (measured)
        QTimer::singleShot(measuredRun, &m_application, [] {
            reportMemory();
            QCoreApplication::exit();
        });
}

void Program::openProject()
{
    if (!m_file.isEmpty())
        m_window->files().open(m_file);
    m_window->compare();
    m_recovery = std::make_unique<ProjectRecovery>(m_project, m_recoveryFolder);
    connect(m_recovery.get(), &ProjectRecovery::told, m_messages.get(), &MessageModel::addNow);
    m_window->askForRecovery(*m_recovery);
}

void Program::attach()
{
    m_window->attach(*m_plant, *m_messages);
    if (const auto warning = nothingIsKept(); !warning.isEmpty())
        m_window->warn(warning);
}

// All texts are made with the window, so it is made again; bus, jobs and messages go on.
void Program::useLanguage(const QString &language)
{
    m_settings.setLanguage(language);
    m_window->saveWindow();
    m_language.use(language);
    const bool visible = m_window->isVisible();
    m_window.reset();
    openWindow();
    m_window->setVisible(visible);
}

} // namespace codewheel
