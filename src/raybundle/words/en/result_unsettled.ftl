# $name = "bench-result"
# $n = 2
# $ids = ["bench-result"]
result_unsettled = The input result { $name } has { $n } { $n ->
        [one] fault
       *[other] faults
     }.
    .why = Its errors are contained in this measurement.
    .do = Settle the faults in its report first.
