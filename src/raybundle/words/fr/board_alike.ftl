board_alike = Le panneau { $board } est identique une fois tourné ; ses points sont tenus fixes, plans.
