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

} // namespace

std::span<const ColumnHead> FinderNewsModel::heads() const
{
    static constexpr ColumnHead all[] = {
        {QT_TR_NOOP("Where")}, {QT_TR_NOOP("Settings")}, {QT_TR_NOOP("How sure")}, {QT_TR_NOOP("What")}};
    return all;
}

QString FinderNewsModel::text(const FinderNews &news, int column) const
{
    switch (column) {
    case place:
        return shownInLine(news.place);
    case settings:
        return news.found ? news.found->settings : QString();
    case sure:
        return news.found ? certaintyText(news.found->certainty) : QString();
    default:
        return shownInLine(news.sentence);
    }
}

QVariant FinderNewsModel::cell(const FinderNews &news, int column, int role) const
{
    if (role == Qt::DecorationRole && column == place)
        return lineIcon(roleIcon(roleOfNews(news)), roleOfNews(news));
    if (role != Qt::FontRole)
        return TableModelBase::cell(news, column, role);
    QFont font;
    font.setBold(news.kind == Kind::found);
    return font;
}

} // namespace codewheel
