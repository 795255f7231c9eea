//! Links libforesee.a, which is in FORESEE_LIB_DIR or where pkg-config finds foresee.

use std::{env, process::Command};

fn folder_of_pkg_config() -> Option<String> {
    let done = Command::new("pkg-config")
        .args(["--variable=libdir", "foresee"])
        .output()
        .ok()?;
    let folder = String::from_utf8(done.stdout).ok()?.trim().to_owned();
    (done.status.success() && !folder.is_empty()).then_some(folder)
}

fn main() {
    println!("cargo:rerun-if-env-changed=FORESEE_LIB_DIR");
    println!("cargo:rerun-if-env-changed=PKG_CONFIG_PATH");
    if env::var_os("CARGO_FEATURE_LINKED").is_none() {
        return;
    }
    let folder = env::var("FORESEE_LIB_DIR").ok().or_else(folder_of_pkg_config).expect(
        "no libforesee.a: install libforesee-dev and pkg-config, or set FORESEE_LIB_DIR to its folder, \
         or use the feature `loaded` with default-features = false",
    );
    println!("cargo:rustc-link-search=native={folder}");
    println!("cargo:rustc-link-lib=static=foresee");
    println!("cargo:rustc-link-lib=stdc++");
}
