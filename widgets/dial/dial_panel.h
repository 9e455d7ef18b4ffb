// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QStackedWidget;

namespace codewheel {

class EncoderSession;
class RodDial;
class ShaftDial;

// The chosen encoder as a picture of what it measures: a disc on a shaft, or a rod with its magnet.
class DialPanel : public QWidget
{
    Q_OBJECT

public:
    explicit DialPanel(QWidget *parent = nullptr);

    void setEncoder(codewheel::EncoderSession *encoder); // null: an empty state

private:
    QStackedWidget *m_pages;
    ShaftDial *m_shaft;
    RodDial *m_rod;
};

} // namespace codewheel
