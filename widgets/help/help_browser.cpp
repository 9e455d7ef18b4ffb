// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/help_browser.h"

#include "widgets/help/manual.h"
#include "widgets/help/manual_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/roles.h"

#include <QFile>
#include <QScrollBar>
#include <QTextBlock>
#include <QTimer>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int markStrength = 90; // of 255: the text stays readable on it

} // namespace

HelpBrowser::HelpBrowser(const Manual &manual, QWidget *parent)
    : QTextBrowser(parent)
    , m_manual(manual)
{
    describe(this, "helpPage", tr("Page of the manual"), {});
    setOpenExternalLinks(true);
    document()->setDocumentMargin(2 * grid::margin);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // or pictures would be fitted twice
    connect(this, &QTextBrowser::sourceChanged, this, &HelpBrowser::preparePage);
}

// Prepares a page as Qt has just read it, whether by a link, a step back or a search. Until then source() is
// still the previous page.
void HelpBrowser::preparePage()
{
    const QUrl page = m_url.adjusted(QUrl::RemoveFragment);
    if (page != m_prepared) {
        m_prepared = page;
        nameHeadings(*document());
        formatManual(*document(), palette());
        findMarks();
        if (const ManualPage *its = m_manual.find(page))
            setDocumentTitle(its->title);
    }
    document()->pageCount(); // lays out all of it
    if (m_url.hasFragment())
        scrollToAnchor(m_url.fragment());
}

void HelpBrowser::doSetSource(const QUrl &url, QTextDocument::ResourceType type)
{
    const QUrl there =
        Manual::translated(m_url.resolved(url)); // pages of other languages lead to English ones
    leaveFor(there);
    QTextBrowser::doSetSource(there, type);
}

void HelpBrowser::backward()
{
    leaveFor(historyUrl(-1));
    QTextBrowser::backward();
    returnToPlace();
}

void HelpBrowser::forward()
{
    leaveFor(historyUrl(1));
    QTextBrowser::forward();
    returnToPlace();
}

void HelpBrowser::leaveFor(const QUrl &url)
{
    if (!url.isValid())
        return; // there is no page to go back to
    m_left[m_url] = verticalScrollBar()->value();
    m_url = url;
}

// Qt scrolls there before the page is formatted.
void HelpBrowser::returnToPlace()
{
    verticalScrollBar()->setValue(m_left.value(m_url));
}

// The pages name the light pictures; each has a dark twin beside it.
QImage HelpBrowser::picture(const QUrl &url) const
{
    const QString light = u':' + url.path();
    QString dark = light;
    dark.replace(QStringLiteral(".png"), QStringLiteral("-dark.png"));
    const bool isDark = shadeOf(palette()) == Shade::dark && QFile::exists(dark);
    QImage image(isDark ? dark : light);
    const int room = viewport()->width() - 2 * qRound(document()->documentMargin()) - manualSlant;
    if (image.width() > room && room > 0) {
        image = image.scaledToWidth(qRound(room * devicePixelRatioF()), Qt::SmoothTransformation);
        image.setDevicePixelRatio(devicePixelRatioF());
    }
    return image;
}

QVariant HelpBrowser::loadResource(int type, const QUrl &name)
{
    if (type == QTextDocument::ImageResource)
        return picture(m_url.resolved(name));
    return QTextBrowser::loadResource(type, name);
}

void HelpBrowser::resizeEvent(QResizeEvent *event)
{
    QTextBrowser::resizeEvent(event);
    if (viewport()->width() == m_width)
        return;
    m_width = viewport()->width();
    QTimer::singleShot(0, this, &HelpBrowser::fitPictures); // not while the page is laid out
}

void HelpBrowser::fitPictures()
{
    const int top = verticalScrollBar()->value();
    bool isAny = false;
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part)
            if (const QTextImageFormat image = part.fragment().charFormat().toImageFormat();
                image.isValid() && !image.name().isEmpty()) {
                const QUrl name(image.name());
                document()->addResource(QTextDocument::ImageResource, name, picture(m_url.resolved(name)));
                isAny = true;
            }
    if (isAny)
        document()->markContentsDirty(0, document()->characterCount());
    verticalScrollBar()->setValue(top);
}

// Light or dark: pictures, links and lines change.
void HelpBrowser::changeEvent(QEvent *event)
{
    QTextBrowser::changeEvent(event);
    if (event->type() != QEvent::PaletteChange || m_prepared.isEmpty())
        return;
    const int top = verticalScrollBar()->value();
    m_prepared.clear();
    reload();
    preparePage();
    verticalScrollBar()->setValue(top);
}

void HelpBrowser::mark(const QStringList &words)
{
    m_words = words;
    findMarks();
}

void HelpBrowser::findMarks()
{
    m_marks.clear();
    QList<ExtraSelection> selections;
    QColor color = roleColor(Role::attention, palette());
    color.setAlpha(markStrength);
    for (const QString &word : std::as_const(m_words))
        for (QTextCursor at = document()->find(word, 0); !at.isNull(); at = document()->find(word, at)) {
            ExtraSelection selection{at, {}};
            selection.format.setBackground(color);
            selections << selection;
            m_marks << at;
        }
    std::ranges::sort(m_marks, {}, &QTextCursor::selectionStart);
    setExtraSelections(selections);
}

void HelpBrowser::choose(const QTextCursor &mark)
{
    setTextCursor(mark);
    ensureCursorVisible();
}

int HelpBrowser::goToMark(bool forward)
{
    if (m_marks.isEmpty())
        return 0;
    const QTextCursor now = textCursor();
    auto found = m_marks.cbegin();
    if (forward) {
        found = std::ranges::find_if(
            m_marks, [&](const QTextCursor &mark) { return mark.selectionStart() >= now.selectionEnd(); });
        if (found == m_marks.cend())
            found = m_marks.cbegin();
    } else {
        found = std::ranges::find_if(
            m_marks, [&](const QTextCursor &mark) { return mark.selectionStart() >= now.selectionStart(); });
        found = std::prev(found == m_marks.cbegin() ? m_marks.cend() : found);
    }
    choose(*found);
    return static_cast<int>(found - m_marks.cbegin()) + 1;
}

int HelpBrowser::goToFirstMark()
{
    const int from = cursorForPosition({0, 0}).position();
    auto found = std::ranges::find_if(
        std::as_const(m_marks), [from](const QTextCursor &mark) { return mark.selectionStart() >= from; });
    if (m_marks.isEmpty())
        return 0;
    if (found == m_marks.cend())
        found = m_marks.cbegin();
    choose(*found);
    return static_cast<int>(found - m_marks.cbegin()) + 1;
}

} // namespace codewheel
