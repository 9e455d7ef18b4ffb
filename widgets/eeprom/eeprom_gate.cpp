// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/eeprom/eeprom_gate.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>

namespace codewheel {

EepromGate::EepromGate(QWidget *parent)
    : QWidget(parent)
    , m_count(new QLabel(this))
    , m_icon(new QLabel(this))
    , m_text(new QLabel(this))
    , m_nevertheless(describe(new QCheckBox(tr("Write &nevertheless"), this), "writeNevertheless",
                              tr("The EEPROM was written as often as the manual speaks of")))
    , m_place(describe(new QLineEdit(this), "typedPlace", tr("Place, to write nevertheless"),
                       tr("The place of the encoder, so that nothing is written beyond the limit by "
                          "accident")))
{
    m_count->setObjectName(QStringLiteral("eepromCount"));
    m_text->setObjectName(QStringLiteral("eepromConcern"));
    m_count->setWordWrap(true);
    m_text->setWordWrap(true);
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(grid::unit);
    grid->setColumnStretch(1, 1);
    grid->addWidget(m_count, 0, 0, 1, 2);
    grid->addWidget(m_icon, 1, 0, Qt::AlignTop);
    grid->addWidget(m_text, 1, 1);
    grid->addWidget(m_nevertheless, 2, 1);
    grid->addWidget(m_place, 3, 1);
    connect(m_nevertheless, &QCheckBox::toggled, this, &EepromGate::changed);
    connect(m_place, &QLineEdit::textChanged, this, &EepromGate::changed);
    hide();
}

void EepromGate::setWrites(EncoderSession &encoder, int planned)
{
    if (m_encoder != &encoder) {
        if (m_encoder)
            m_encoder->disconnect(this);
        m_encoder = &encoder;
        m_concern = EepromConcern::none;
        connect(&encoder, &EncoderSession::eepromCountChanged, this, [this] {
            showConcern();
            Q_EMIT changed();
        });
    }
    m_planned = planned;
    showConcern();
}

void EepromGate::showConcern()
{
    if (!m_encoder)
        return;
    const bool isKept = m_encoder->eepromCount().by != CountedBy::session;
    const EepromConcern concern = eepromConcern(*m_encoder, m_planned);
    if (std::exchange(m_concern, concern) != concern) {
        m_nevertheless->setChecked(false);
        m_place->clear();
    }
    const QString place = m_encoder->place().shown();
    const QString ask = tr("Type %1 to write nevertheless").arg(place);
    m_place->setPlaceholderText(ask);
    m_place->setAccessibleName(ask);
    m_count->setText(isKept ? eepromCountText(*m_encoder) : QString());
    m_count->setVisible(isKept);
    m_text->setText(eepromConcernText(*m_encoder, m_planned));
    m_text->setVisible(concern != EepromConcern::none);
    m_icon->setVisible(concern != EepromConcern::none);
    m_nevertheless->setVisible(concern == EepromConcern::question);
    m_place->setVisible(concern == EepromConcern::typed);
    setVisible(isKept || concern != EepromConcern::none);
    drawIcon();
}

bool EepromGate::isOpen() const
{
    switch (m_concern) {
    case EepromConcern::question:
        return m_nevertheless->isChecked();
    case EepromConcern::typed:
        return m_encoder && m_place->text().trimmed() == m_encoder->place().shown();
    default:
        return true;
    }
}

void EepromGate::drawIcon()
{
    const Role role = m_concern == EepromConcern::typed ? Role::fault : Role::attention;
    m_icon->setPixmap(
        lineIcon(roleIcon(role), role).pixmap(QSize(grid::smallIcon, grid::smallIcon), devicePixelRatioF()));
}

void EepromGate::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange)
        drawIcon();
}

} // namespace codewheel
