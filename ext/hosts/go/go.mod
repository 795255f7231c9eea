module foresee

go 1.18
