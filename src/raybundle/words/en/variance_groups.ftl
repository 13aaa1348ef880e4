# $n = 3
variance_groups = Each of { $n } groups of observations has a variance factor of its own.

variance_groups-unsettled = Groups of observations contradict each other; their variance factors do not converge.
    .why = All groups carry one common factor, so errors of one group enlarge all standard deviations.
    .do = Find the contradicting observations first.

# $kind = "camera"
# $group = "d5100"
# $factor = 1.3
# $count = 5871
# $redundancy = 5100.0
variance_groups-group = { observations-kind } ({ $group }): standard deviations × { NUM($factor, digits: 3) } ({ $count } values, redundancy { NUM($redundancy, digits: 3) })

# $kind = "camera"
# $group = "d5100"
# $count = 5871
# $redundancy = 5100.0
variance_groups-as_given = { observations-kind } ({ $group }): standard deviations as given ({ $count } values, redundancy { NUM($redundancy, digits: 3) })
