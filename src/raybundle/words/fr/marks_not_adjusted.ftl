marks_not_adjusted = Le résultat ne contient pas les points mesurés de ce projet : ils ne peuvent pas être compensés avec lui.
