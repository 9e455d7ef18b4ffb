// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/place.h"

#include <QWidget>

#include <optional>

class QStackedWidget;

namespace codewheel {

class EmptyState;
class EncoderSession;
class RodDial;
class ShaftDial;

// The chosen encoder as a picture of what it measures: a disc on a shaft, or a rod with its magnet.
class DialPanel : public QWidget
{
    Q_OBJECT

public:
    explicit DialPanel(QWidget *parent = nullptr);

    // Null: an empty state, which says so if the chosen encoder is not connected.
    void setEncoder(codewheel::EncoderSession *encoder, std::optional<codewheel::Place> offline = {});

private:
    QStackedWidget *m_pages;
    EmptyState *m_empty;
    ShaftDial *m_shaft;
    RodDial *m_rod;
};

} // namespace codewheel
