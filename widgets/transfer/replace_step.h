// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transfer/replacement.h"

#include <QWidget>

#include <functional>

namespace codewheel {

class Buses;
class Catalog;
class ProjectDocument;

// What the steps of ReplacePage pass on to each other.
struct Replacing
{
    const Buses &buses;
    const Catalog &catalog;
    ProjectDocument &project;
    Place place{};
    ProjectDevice before{};                 // as planned until writing begins
    Replacement now{};                      // device null: not chosen yet
    QString key{};                          // of its label, as typed
    std::optional<std::int64_t> position{}; // to be set; nothing: left as it is
};

// One step of the replacement of an encoder.
class ReplaceStep : public QWidget
{
    Q_OBJECT

public:
    ReplaceStep(Replacing &replacing, const QString &title, QWidget *parent = nullptr)
        : QWidget(parent)
        , m_replacing(replacing)
        , m_title(title)
    {
        setAccessibleName(title);
    }

    const QString &title() const { return m_title; }
    virtual void enter() {}
    // The project has changed while the step is shown.
    virtual void refresh() { enter(); }
    // Takes the input of the step; false: the step says what is missing.
    virtual bool leave() { return true; }
    virtual bool mayGoOn() const { return true; }
    virtual bool mayGoBack() const { return true; }
    virtual QString nextText() const { return tr("&Next"); }
    virtual bool isBusy() const { return false; } // something is sent
    // What the step itself sends; empty: nothing.
    virtual QString effect() const { return {}; }
    // What it has done for good that the page does not know; empty: nothing.
    virtual QString doneSoFar() const { return {}; }

Q_SIGNALS:
    void changed();    // mayGoOn, mayGoBack
    void givesPlace(); // to the new encoder, which may show itself there from now on

protected:
    Replacing &m_replacing;

private:
    QString m_title;
};

// The steps that a kind of bus adds to a replacement; null: none.
struct ReplaceStepsOfKind
{
    ReplaceStep *begin = nullptr; // before anything is written: the new encoder takes its place on the bus
    ReplaceStep *end = nullptr;   // once all was written
};
// For the encoder at the place of `replacing`, which outlives them.
using MakeReplaceSteps = std::function<ReplaceStepsOfKind(Replacing &replacing)>;

} // namespace codewheel
