// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/place.h"

#include <QTimer>
#include <QWidget>

#include <optional>

class QTreeView;

namespace codewheel {

class BusSession;
class Catalog;
class EmptyState;
class InlineMessage;
class LineSession;
class ProjectDocument;
class StructureModel;

// The bus structure as a tree. The chosen device is what the panels beside it show; Enter or a double click
// opens its monitors.
class StructureView : public QWidget
{
    Q_OBJECT

public:
    explicit StructureView(QWidget *parent = nullptr);

    // Chooses the first encoder. Null: offline, the ring that the project plans.
    void setBus(BusSession *bus);
    // What is chosen stays so, if it is still there. Null: no serial line.
    void setLine(codewheel::LineSession *line);
    // Both must outlive the view.
    void setProject(const ProjectDocument &project, const Catalog &catalog);
    std::optional<Place> current() const;
    void choose(Place number);

    void chooseLine(); // the line itself

Q_SIGNALS:
    void chosen(codewheel::Place number);
    void opened(codewheel::Place number);
    // Which make the chosen device is, the bus does not tell: the user wants to.
    void namingRequested(codewheel::Place number);
    void menuRequested(codewheel::Place number, const QPoint &globalPosition);
    // The row of the serial line itself.
    void lineChosen();
    void lineOpened();
    void lineMenuRequested(const QPoint &globalPosition);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    int narrowestName() const;
    int widestPosition() const;
    int roomForNames() const;
    void measureColumns();
    void placeColumns();
    void showWhetherEmpty();
    void askForMake();

    BusSession *m_bus = nullptr;
    StructureModel *m_model;
    QTreeView *m_tree;
    EmptyState *m_empty;
    InlineMessage *m_question;
    QTimer m_measuring;
    int m_widestName = 0; // px
    int m_levels = 0;     // of the tree, the master one of them
};

} // namespace codewheel
