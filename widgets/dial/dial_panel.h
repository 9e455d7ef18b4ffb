// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"
#include "widgets/look/printed_view.h"

#include <QPointer>
#include <QWidget>

#include <optional>

class QAction;
class QStackedWidget;

namespace codewheel {

class DialHead;
class EmptyState;
class RodDial;
class ShaftDial;
struct Track;

// The chosen encoder as a picture of what it measures: a disc on a shaft, or a rod with its magnet.
class DialPanel : public QWidget, public PrintsPicture
{
    Q_OBJECT

public:
    explicit DialPanel(QWidget *parent = nullptr);

    // Null: an empty state, which says so if the chosen encoder is not connected.
    void setEncoder(codewheel::EncoderSession *encoder, std::optional<codewheel::Place> offline = {});
    // Its bus is connected, without an encoder there.
    void setAbsent(codewheel::Place planned);
    void setAway(Place pinned);
    DialHead &head() { return *m_head; }

    std::optional<PrintedView> printedView() const override;
    // For its context menu, while there is something to print; it outlives the panel.
    void setPrinting(QAction &print) { m_print = &print; }

Q_SIGNALS:
    void trendWanted(const codewheel::Track &track);

protected:
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    QPointer<EncoderSession> m_encoder;
    DialHead *m_head;
    QStackedWidget *m_pages;
    EmptyState *m_empty;
    ShaftDial *m_shaft;
    RodDial *m_rod;
    QAction *m_print = nullptr;
};

} // namespace codewheel
