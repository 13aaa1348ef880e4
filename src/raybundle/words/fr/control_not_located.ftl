control_not_located = Un point d'appui sur { $n } est faux, lequel est ambigu : { $ids }.

control_not_located-datum = Le point d'appui { $point } contredit les autres observations (|w| { NUM($w, decimals: 1) }) et participe quand même.

control_not_located-unfinished = Le point d'appui { $point } contredit les autres observations (|w| { NUM($w, decimals: 1) }) et participe quand même.
