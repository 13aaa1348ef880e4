control_not_observed = { $n } point(s) d'appui ne sont mesurés dans aucune image et ne participent pas : { $ids }.

control_not_observed-rejected = { $n } point(s) d'appui ne participent pas : tous leurs points image ont été rejetés ({ $ids }).
