// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/line/esc_line_terminal.h"

#include "kinds/esc/driver/esc_values.h"
#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/line/typed_request.h"
#include "kinds/esc/line/write_question.h"
#include "project/file_access.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/job/known_text.h"
#include "widgets/kinds/esc/line/esc_line_record_view.h"
#include "widgets/kinds/esc/line/request_field.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/save_file.h"
#include "widgets/monitor/meaning_line.h"
#include "widgets/trace/traffic_table.h"

#include <QAction>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QPushButton>
#include <QStackedWidget>

#include <algorithm>

namespace codewheel {
namespace {

// The context of these texts.
struct EscLineRecordFiles
{
    Q_DECLARE_TR_FUNCTIONS(EscLineRecordFiles)
};

constexpr qint64 largestFile = 64'000'000; // bytes; 100 000 rows take 9 000 000

// Replaces the file as a whole or not at all.
tl::expected<void, QString> writeWholeFile(const QString &path, const QByteArray &content)
{
    return replaceFile(path, content, OldFile::goes).map_error([&](const Refusal &refusal) {
        return sentence(EscLineRecordFiles::tr("%1 was not saved: %2", "file, reason"),
                        {path, whyNotWritten(refusal)});
    });
}

// Includes the waiting rows.
std::vector<EscLineRecord::Row> recordRows(const TrafficModel &model)
{
    std::vector<EscLineRecord::Row> kept;
    for (const auto *part : {&model.rows(), &model.waitingRows()})
        for (const ShownTraffic &row : *part)
            kept.push_back({{row.what.at, *row.what.kind, row.what.bytes}, row.what.isTyped});
    if (kept.size() > EscLineRecord::mostRows)
        kept.erase(kept.begin(), kept.end() - static_cast<std::ptrdiff_t>(EscLineRecord::mostRows));
    return kept;
}

} // namespace

EscLineTerminal::Collected EscLineTerminal::takeRows()
{
    m_rows->setParent(nullptr);
    return {std::shared_ptr<const TrafficModel>(m_rows), m_begin};
}

void EscLineTerminal::goOn(const Collected &before)
{
    m_rows->goOnFrom(*before.rows);
    m_begin = before.begin;
}

void EscLineTerminal::setRecordingChosen(bool isChosen)
{
    if (std::exchange(m_isRecordingChosen, isChosen) == isChosen)
        return;
    m_question->withdraw();
    showWhatIsPossible();
}

void EscLineTerminal::setMostRows(int rows)
{
    m_rows->setMost(rows);
}

void EscLineTerminal::setLine(EscLineSession *line)
{
    if (m_line)
        m_line->disconnect(this);
    m_rows->showWaiting();
    m_line = line;
    m_typed.reset();
    m_question->withdraw();
    m_record->setLine(line);
    if (line) {
        m_answer->hide(); // it belongs to another line
        if (m_rows->isEmpty() && !m_rows->hasCleared())
            m_begin = line->dateTime({});
        connect(line, &EscLineSession::trafficPassed, this, &EscLineTerminal::add);
        connect(line, &EscLineSession::updated, this, &EscLineTerminal::followPosition);
        connect(line, &EscLineSession::updated, this, [this] {
            if (!visibleRegion().isEmpty())
                m_rows->showWaiting();
        });
        connect(line, &EscLineSession::typedAnswered, this, &EscLineTerminal::takeAnswer);
        connect(line, &EscLineSession::stateChanged, this, [this] {
            m_question->withdraw();
            showWhatIsPossible();
        });
        connect(line, &EscLineSession::alarmStopped, this, [this] {
            m_question->withdraw();
            m_typed.reset();
        });
        connect(line, &QObject::destroyed, this, [this] { setLine(nullptr); });
    }
    showWhatIsPossible();
}

void EscLineTerminal::setExplainOptions(const esc::ExplainOptions &options)
{
    m_options = options;
    m_field->setFractionBits(options.fractionBits);
    m_rows->tellMeaningsChanged();
    m_record->setExplainOptions(options);
}

// Shows what came while nobody looked. Not in showEvent(), which also comes behind another tab.
void EscLineTerminal::paintEvent(QPaintEvent *event)
{
    QWidget::paintEvent(event);
    if (m_rows->waiting() > 0 && !m_rows->isHeld())
        QMetaObject::invokeMethod(m_rows, &TrafficModel::showWaiting, Qt::QueuedConnection);
}

QStringList EscLineTerminal::history() const
{
    return m_field->history();
}

void EscLineTerminal::setHistory(const QStringList &history)
{
    m_field->setHistory(history);
}

bool EscLineTerminal::isConnected() const
{
    return m_line && m_line->isOpen() && m_line->latest().connected;
}

std::optional<Refusal> EscLineTerminal::whyNotSent() const
{
    if (m_isRecordingChosen)
        return Refusal{RefusalKind::notSupported, RefusalId::onlyRecorded, {}};
    if (!isConnected())
        return Refusal{RefusalKind::link, RefusalId::lineClosed, {}};
    return std::nullopt;
}

bool EscLineTerminal::hasJob() const
{
    return std::ranges::any_of(m_line->latest().devices, &EscLineSnapshot::Device::hasJob);
}

// Rows of several connections, and from before and after the computer slept, share one clock.
void EscLineTerminal::add(const TrafficRow &row)
{
    const auto onItsClock = std::chrono::duration_cast<std::chrono::milliseconds>(row.at);
    const std::chrono::milliseconds onOurs{m_begin.msecsTo(row.time)};
    TrafficRow shifted = row;
    shifted.at += onOurs - onItsClock;
    m_rows->add(std::move(shifted));
}

void EscLineTerminal::send()
{
    m_question->withdraw();
    m_message->withdraw();
    const auto request = typedRequest(m_field->text(), m_options.fractionBits);
    if (!request) {
        m_message->showMessage(Role::attention, request.error());
        return;
    }
    if (const auto why = whyNotSent())
        m_message->showMessage(Role::attention, refusalText(*why));
    else if (esc::shapeOf(request->command).writes)
        askBeforeWrite(*request);
    else
        sendNow(*request);
}

void EscLineTerminal::askBeforeWrite(const esc::Request &request)
{
    const QString place = placeOnLine(request.to).toString();
    if (!m_line->isOperating())
        m_message->showMessage(Role::attention,
                               refusalText({RefusalKind::busy, RefusalId::watchOnly, {place}}));
    else if (hasJob())
        m_message->showMessage(Role::attention,
                               tr("Nothing was sent: a job is running on this line. Wait until "
                                  "it has ended, or cancel it."));
    else {
        m_asked = request;
        m_question->showMessage(Role::attention, questionText(request), tr("Send and &write"),
                                tr("Do &not send"));
    }
}

QString EscLineTerminal::questionText(const esc::Request &request) const
{
    return whoIsAt(request) + writeQuestion(request, m_options) + whatItShows(request);
}

// If it gives an encoder the address of another one. Empty: it does not.
QString EscLineTerminal::whoIsAt(const esc::Request &request) const
{
    if (request.command != esc::Command::writeAddress)
        return {};
    const auto taken = m_line->addressTaken({static_cast<std::uint8_t>(request.data)}, request.to);
    return taken ? refusalText(*taken) + u' ' : QString();
}

// Before its position is set. Empty for anything else, and where no encoder is known.
QString EscLineTerminal::whatItShows(const esc::Request &request) const
{
    const EncoderSession *encoder =
        request.command == esc::Command::writePreset ? m_line->encoder(request.to.node()) : nullptr;
    return encoder != nullptr ? u' ' + positionNowTexts(*encoder).join(u' ') : QString();
}

void EscLineTerminal::followPosition()
{
    if (m_question->isHidden() || !m_asked)
        return;
    const QString text = questionText(*m_asked);
    if (text == m_question->sentence())
        return;
    m_question->rephrase(text);
    keepQuestionWhole();
}

void EscLineTerminal::sendNow(const esc::Request &request)
{
    m_typed = request;
    m_line->send(request);
    m_field->keep();
    m_field->setFocus();
    m_follow->setChecked(true); // whoever sends wants to see the answer
    Q_EMIT historyChanged();
}

void EscLineTerminal::takeAnswer(const TypedAnswered &answer)
{
    if (answer.result.sent > 0)
        m_rows->markTyped(answer.request.bytes());
    if (m_typed != answer.request)
        return;
    m_typed.reset();
    showAnswer(answer);
    if (answer.result.answer || answer.result.sent == 0)
        return;
    const bool isWrite = esc::shapeOf(answer.request.command).writes;
    m_message->showMessage(
        Role::attention,
        sentence(
            isWrite ? tr("No answer to %1. Whether it was carried out is unknown: read the value back. It is "
                         "not sent again by itself.")
                    : tr("No answer to %1. Check address and baud rate, or look for encoders."),
            {QString::fromLatin1(answer.request.text())}));
}

void EscLineTerminal::showAnswer(const TypedAnswered &answer)
{
    const auto &came = answer.result.answer;
    const QString meaning = came ? esc::answerText(answer.request, *came, m_options) : tr("no answer");
    m_answer->setText(
        sentence(QStringLiteral("%1: %2"), {QString::fromLatin1(answer.request.text()), meaning}));
    m_answer->show();
}

bool EscLineTerminal::save(const QString &path)
{
    EscLineRecord record{.begin = m_begin, .port = {}, .rows = recordRows(*m_rows)};
    if (m_line) {
        record.port = m_line->linkName();
        record.baudRate = m_line->settings().baudRate;
    }
    const auto saved = writeWholeFile(path, lineRecordToJson(record));
    if (!saved)
        m_message->showMessage(Role::attention, saved.error());
    else
        m_message->withdraw();
    return saved.has_value();
}

bool EscLineTerminal::open(const QString &path)
{
    const auto json = readWholeFile(path, largestFile).map_error(refusalText);
    const auto record = json.and_then(
        [&](const QByteArray &read) { return lineRecordFromJson(read, QFileInfo(path).fileName()); });
    if (!record) {
        m_message->showMessage(Role::attention, record.error());
        return false;
    }
    m_message->withdraw();
    m_record->showRecord(*record, QFileInfo(path).fileName());
    m_pages->setCurrentWidget(m_record);
    return true;
}

bool EscLineTerminal::exportText(const QString &path)
{
    m_rows->showWaiting();
    const auto written = writeWholeFile(path, m_table->exportText().toUtf8());
    if (!written)
        m_message->showMessage(Role::attention, written.error());
    else
        m_message->withdraw();
    return written.has_value();
}

void EscLineTerminal::askSave()
{
    const QString path = askSaveFile(this, tr("Save the session"), tr("line-session.json", "name of a file"),
                                     {tr("Line sessions (*.json)")});
    if (!path.isEmpty())
        save(path);
}

void EscLineTerminal::askOpen()
{
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open a session"), {}, tr("Line sessions (*.json)"));
    if (!path.isEmpty())
        open(path);
}

void EscLineTerminal::askExport()
{
    const QString path = askSaveFile(this, tr("Export the rows"), tr("line.txt", "name of a file"),
                                     {tr("Text files (*.txt)")});
    if (!path.isEmpty())
        exportText(path);
}

void EscLineTerminal::showCounts()
{
    m_counts->setText(m_rows->countsText(m_table->model()->rowCount()));
    m_content->setCurrentIndex(m_rows->isEmpty() ? 1 : 0);
    m_save->setEnabled(!m_rows->isEmpty());
    m_bringBack->setEnabled(m_rows->hasCleared());
}

void EscLineTerminal::showWhatIsPossible()
{
    const auto whyNot = whyNotSent();
    const QString why = whyNot ? refusalText(*whyNot) : QString();
    m_field->setEnabled(!whyNot);
    m_send->setEnabled(!whyNot);
    m_field->setToolTip(!whyNot ? tr("Address and command, as in 05P. Up and Down: what was typed before. "
                                     "Ctrl+Space: all commands.")
                                : why);
    m_send->setToolTip(!whyNot ? tr("Sends the request (Enter)") : why);
}

} // namespace codewheel
