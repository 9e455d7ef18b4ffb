// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"

#include <QObject>
#include <QUndoStack>

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace codewheel {

class ProjectStep;

// The project that is open, and all that can be undone in it. What views show and change of it goes through
// here: structure editor, wanted values, cams, sequences. Outlives the window, which is made anew in another
// language.
//
// A device has an id besides its number: the number follows from its place, the id stays.
class ProjectDocument : public QObject
{
    Q_OBJECT

public:
    using DeviceId = unsigned;
    // Changes of one gesture, such as typing in one field or a drag of the mouse, are one step of undo.
    using Gesture = int;
    static constexpr Gesture noGesture = 0;
    // Where each device of a bus stood before an edit, among those of the bus; nothing: it is new.
    using Origins = std::vector<std::optional<std::size_t>>;

    explicit ProjectDocument(QObject *parent = nullptr);
    ~ProjectDocument() override;

    const Project &project() const { return m_project; }
    // Of the devices of a bus, in its order.
    std::span<const DeviceId> ids(BusId bus) const;
    std::optional<DeviceId> idAt(Place place) const; // nothing: it is not planned
    const ProjectDevice *device(DeviceId id) const;  // null: there is none any more
    // Among those of its bus.
    std::optional<std::size_t> indexOf(DeviceId id) const;
    // What is planned for the device of this number. One that the project does not have (a connected ring may
    // have others) can be given values as well: they go with it into the project once it is planned under
    // this number. Until then they are in no file, and the project is not saved.
    const ProjectDevice &device(Place number) const;
    // Those of the ring that have values, and that the project does not have.
    std::vector<Place> notPlanned() const;
    void forEachDevice(const std::function<void(Place, const ProjectDevice &)> &visit) const;

    // Another project, or the same read from its file again. There is nothing to undo then. fileMark:
    // projectMark() of what the file held.
    void setProject(Project project, const QString &file, const QByteArray &fileMark = {});
    QString file() const { return m_file; }                             // empty: it has none yet
    void setFile(const QString &file, const QByteArray &fileMark = {}); // it was saved there, as it is now
    // Of what the file held when it was read, or saved here; empty: not known.
    const QByteArray &fileMark() const { return m_fileMark; }
    bool isSaved() const { return m_undo.isClean() && !m_isRecovered && notPlanned().empty(); }
    // It was found after a crash: its file has something else.
    void setRecovered();

    // A step of undo; none where nothing changes. what: its name, "Move 3.0". No origins: each device stands
    // where it stood; where there are more or less of them, those between what is the same are new.
    void edit(Project after, const QString &what, Gesture gesture = noGesture);
    void edit(Project after, BusId bus, const Origins &origins, const QString &what);
    void editDevice(Place number, const QString &what, const std::function<void(ProjectDevice &)> &edit,
                    Gesture gesture = noGesture);
    // The encoder has another address now: all that is planned and known of it goes along. Nothing is to be
    // planned for `to` any more: what stands there is replaced.
    void renumber(Place from, Place to, const QString &what);
    Gesture newGesture() { return ++m_lastGesture; }

    QUndoStack &undoStack() { return m_undo; }

Q_SIGNALS:
    void changed();     // anything of the project or of its devices
    void replaced();    // by another one; changed() comes as well
    void fileChanged(); // its name
    void savedChanged(bool isSaved);

private:
    friend class ProjectStep;
    struct Content; // all that a step changes but the devices
    Content content() const;
    void apply(const Content &content, std::size_t first, std::size_t count,
               const std::vector<ProjectDevice> &devices, const std::vector<DeviceId> &ids);
    void push(Project after, std::vector<DeviceId> ids, std::map<Place, ProjectDevice> others,
              const QString &what, Gesture gesture);
    void pushPlanned(Project after, std::vector<DeviceId> ids, const QString &what, Gesture gesture);
    std::vector<DeviceId> keptIds(const Project &after);

    Project m_project;
    std::vector<DeviceId> m_ids;
    std::map<Place, ProjectDevice> m_others; // of devices that the project does not have
    QString m_file;
    QByteArray m_fileMark;
    QUndoStack m_undo;
    bool m_isRecovered = false;
    DeviceId m_lastId = 0;
    Gesture m_lastGesture = noGesture;
};

} // namespace codewheel
