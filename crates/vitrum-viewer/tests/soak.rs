//! A short while of random input: no panic, and the window shows pictures as before.

mod random_user;

use random_user::RandomUser;

#[test]
fn a_user_who_does_anything_breaks_nothing() {
    let mut user = RandomUser::new(7);
    user.rest("builtin:ball");
    for _ in 0..150 {
        user.act();
    }
    user.rest("builtin:ball");
}
