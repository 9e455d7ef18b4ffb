// SPDX-License-Identifier: GPL-3.0-or-later
// The files of the cam editor.
#include "cams/check_cams.h"
#include "catalog/catalog.h"
#include "project/file_access.h"
#include "vocabulary/refusal_text.h"
#include "widgets/cams/cam_board.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/job/outcome_text.h"
#include "widgets/look/save_file.h"

#include <QFileDialog>
#include <QFileInfo>

namespace codewheel {
namespace {

// The desktop opens *.cwcams with the program; the files of earlier versions are called *.json.
QString camFilter()
{
    return CamEditor::tr("Cam programs (*.cwcams *.json)");
}

} // namespace

void CamEditor::askLoad()
{
    const QString path = QFileDialog::getOpenFileName(this, tr("Open cam programs"), {}, camFilter());
    if (!path.isEmpty())
        load(path);
}

void CamEditor::askLoadProgram()
{
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open cam program %1").arg(m_sheet->number()), {}, camFilter());
    if (!path.isEmpty())
        loadProgram(path);
}

void CamEditor::askSave()
{
    const QString path = askSaveFile(this, tr("Save all cam programs"), tr("cams.cwcams"), {camFilter()});
    if (!path.isEmpty())
        save(path);
}

void CamEditor::askSaveProgram()
{
    const QString path = askSaveFile(this, tr("Save cam program %1").arg(m_sheet->number()),
                                     tr("cams-%1.cwcams", "file name").arg(m_sheet->number()), {camFilter()});
    if (!path.isEmpty())
        saveProgram(path);
}

// Only a file made for this encoder, with no position above its largest.
tl::expected<CamFile, QString> CamEditor::open(const QString &path) const
{
    const QString name = QFileInfo(path).fileName();
    const auto largest = m_sheet->knowsLargest() ? std::optional(m_sheet->largest()) : std::nullopt;
    auto file = readWholeFile(path, largestCamFile).and_then([&](const QByteArray &json) {
        return camFileFromJson(json, name, largest);
    });
    if (!file)
        return tl::unexpected(refusalText(file.error()));
    if (m_encoder.isThere() && !suits(*file, m_encoder.device(), m_catalog.find(file->device)))
        return tl::unexpected(otherDeviceText(*file, m_encoder.device(), name));
    for (const CamProgram &program : file->programs)
        if (const auto checked = check(program, m_sheet->abilities(), m_sheet->largest()); !checked)
            return tl::unexpected(refusalText(checked.error()));
    return *file;
}

bool CamEditor::load(const QString &path)
{
    const auto file = open(path);
    if (!file) {
        say(Cause::file, Role::fault, file.error());
        return false;
    }
    m_sheet->document().setPrograms(file->programs, tr("Open %1").arg(QFileInfo(path).fileName()));
    if (file->programs.size() == 1)
        chooseProgram(file->programs.front().number);
    say(Cause::file, Role::running,
        tr("Loaded from %1: program %2.").arg(QFileInfo(path).fileName(), programList(file->programs)));
    return true;
}

bool CamEditor::loadProgram(const QString &path)
{
    const QString name = QFileInfo(path).fileName();
    const auto program = open(path).and_then([&](const CamFile &file) {
        return camProgramOf(file, m_sheet->number(), name).map_error([](const Refusal &refusal) {
            return refusalText(refusal);
        });
    });
    if (!program) {
        say(Cause::file, Role::fault, program.error());
        return false;
    }
    m_sheet->document().setProgram(*program, tr("Open %1").arg(name));
    withdraw(Cause::file);
    return true;
}

bool CamEditor::save(const QString &path)
{
    if (!m_board->finishEditing())
        return false;
    std::vector<CamProgram> programs;
    for (unsigned number = 1; number <= m_sheet->abilities().programs; ++number)
        programs.push_back(m_sheet->document().program(number));
    return keep(path, programs);
}

bool CamEditor::saveProgram(const QString &path)
{
    return m_board->finishEditing() && keep(path, {m_sheet->program()});
}

bool CamEditor::keep(const QString &path, const std::vector<CamProgram> &programs)
{
    if (!m_encoder.isThere())
        return false;
    CamFile file{.device = m_encoder.device().key, .totalRange = {}, .programs = programs};
    if (m_sheet->knowsLargest())
        file.totalRange = m_sheet->largest() + 1;
    if (const auto saved = replaceFile(path, camFileToJson(file), OldFile::goes); !saved) {
        say(Cause::file, Role::fault,
            tr("%1 was not saved: %2", "file, reason").arg(path, whyNotWritten(saved.error())));
        return false;
    }
    withdraw(Cause::file);
    return true;
}

} // namespace codewheel
