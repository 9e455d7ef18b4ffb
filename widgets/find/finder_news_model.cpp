// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/find/finder_news_model.h"

#include "vocabulary/shown_text.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <QFont>

namespace codewheel {
namespace {

using Kind = FinderNews::Kind;

Role roleOfNews(const FinderNews &news)
{
    if (news.kind == Kind::refused)
        return Role::fault;
    if (news.kind != Kind::found)
        return Role::inactive;
    return news.found->isMasterAtWork ? Role::attention : Role::running;
}

QString newsText(const FinderNews &news, int column)
{
    switch (column) {
    case FinderNewsModel::place:
        return shownInLine(news.place);
    case FinderNewsModel::settings:
        return news.found ? news.found->settings : QString();
    case FinderNewsModel::sure:
        return news.found ? certaintyText(news.found->certainty) : QString();
    default:
        return shownInLine(news.sentence);
    }
}

} // namespace

std::span<const ColumnHead> FinderNewsModel::heads() const
{
    static constexpr ColumnHead all[] = {
        {QT_TR_NOOP("Where")}, {QT_TR_NOOP("Settings")}, {QT_TR_NOOP("How sure")}, {QT_TR_NOOP("What")}};
    return all;
}

QVariant FinderNewsModel::cell(const FinderNews &news, int column, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
        return newsText(news, column);
    case Qt::DecorationRole:
        return column == place ? QVariant(lineIcon(roleIcon(roleOfNews(news)), roleOfNews(news)))
                               : QVariant();
    case Qt::FontRole: {
        QFont font;
        font.setBold(news.kind == Kind::found);
        return font;
    }
    default:
        return {};
    }
}

} // namespace codewheel
