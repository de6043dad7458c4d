struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_13 {
member: array<f32>,
}
struct type_16 {
member: u32,
member_1: u32,
}
struct type_17 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
}
struct type_19 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_20 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_21 {
member: type_2,
member_1: type_16,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_17,
member_12: type_18,
member_13: type_19,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_20,
}
struct type_22 {
member: type_21,
}
struct type_24 {
member: array<u32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(4)
var<storage, read_write> global_1: type_13;
@group(0) @binding(0)
var<storage> global_2: type_22;
@group(0) @binding(1)
var<storage> global_3: type_13;
@group(0) @binding(2)
var<storage> global_4: type_24;
@group(0) @binding(3)
var<storage> global_5: type_24;
fn function_() {
var phi_531_: i32;
var phi_543_: i32;
var phi_634_: u32;
var phi_640_: u32;
var phi_702_: u32;
var phi_708_: u32;
var phi_770_: u32;
var phi_776_: u32;
var phi_799_: vec3<f32>;
var phi_802_: u32;
var phi_903_: i32;
var phi_915_: i32;
var phi_945_: u32;
var phi_946_: u32;
var phi_947_: u32;
var phi_1006_: u32;
var phi_1012_: u32;
var phi_1074_: u32;
var phi_1080_: u32;
var phi_1142_: u32;
var phi_1148_: u32;
var phi_1202_: i32;
var phi_1214_: i32;
var phi_1244_: u32;
var phi_1245_: u32;
var phi_1246_: u32;
var phi_1305_: u32;
var phi_1311_: u32;
var phi_1373_: u32;
var phi_1379_: u32;
var phi_1441_: u32;
var phi_1447_: u32;
var phi_1503_: i32;
var phi_1515_: i32;
var phi_1545_: u32;
var phi_1546_: u32;
var phi_1547_: u32;
var phi_1606_: u32;
var phi_1612_: u32;
var phi_1674_: u32;
var phi_1680_: u32;
var phi_1742_: u32;
var phi_1748_: u32;
var phi_1803_: i32;
var phi_1815_: i32;
var phi_1845_: u32;
var phi_1846_: u32;
var phi_1847_: u32;
var phi_1906_: u32;
var phi_1912_: u32;
var phi_1974_: u32;
var phi_1980_: u32;
var phi_2042_: u32;
var phi_2048_: u32;
var phi_800_: vec3<f32>;
var phi_803_: u32;
var local: vec3<f32>;
var local_1: vec3<f32>;
var local_2: vec3<f32>;
var phi_2138_: i32;
var phi_2150_: i32;
var phi_2241_: u32;
var phi_2247_: u32;
var phi_2309_: u32;
var phi_2315_: u32;
var phi_2377_: u32;
var phi_2383_: u32;
var phi_2406_: vec3<f32>;
var phi_2409_: u32;
var local_3: u32;
var phi_2510_: i32;
var phi_2522_: i32;
var phi_2552_: u32;
var phi_2553_: u32;
var phi_2554_: u32;
var phi_2613_: u32;
var phi_2619_: u32;
var phi_2681_: u32;
var phi_2687_: u32;
var phi_2749_: u32;
var phi_2755_: u32;
var phi_2809_: i32;
var phi_2821_: i32;
var phi_2851_: u32;
var phi_2852_: u32;
var phi_2853_: u32;
var phi_2912_: u32;
var phi_2918_: u32;
var phi_2980_: u32;
var phi_2986_: u32;
var phi_3048_: u32;
var phi_3054_: u32;
var phi_3110_: i32;
var phi_3122_: i32;
var phi_3152_: u32;
var phi_3153_: u32;
var phi_3154_: u32;
var phi_3213_: u32;
var phi_3219_: u32;
var phi_3281_: u32;
var phi_3287_: u32;
var phi_3349_: u32;
var phi_3355_: u32;
var phi_3410_: i32;
var phi_3422_: i32;
var phi_3452_: u32;
var phi_3453_: u32;
var phi_3454_: u32;
var phi_3513_: u32;
var phi_3519_: u32;
var phi_3581_: u32;
var phi_3587_: u32;
var phi_3649_: u32;
var phi_3655_: u32;
var phi_2407_: vec3<f32>;
var phi_2410_: u32;
var local_4: vec3<f32>;
var local_5: vec3<f32>;
var local_6: vec3<f32>;
let _e53 = global;
let _e62 = global_2.member.member;
if (_e53.x < _e62.member) {
if (_e53.y < _e62.member_1) {
let _e69 = (_e62.member * _e62.member_1);
let _e71 = ((_e53.y * _e62.member) + _e53.x);
let _e75 = global_2.member.member.member;
let _e79 = global_2.member.member.member_1;
let _e80 = (_e75 * _e79);
let _e82 = ((_e53.y * _e75) + _e53.x);
let _e83 = bitcast<i32>(_e82);
let _e85 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e87 = select(_e85, _e83, (_e83 < _e85));
let _e93 = global_3.member[bitcast<u32>(select(0i, _e87, (_e87 > 0i)))];
let _e96 = bitcast<i32>(((3u * _e80) + _e82));
let _e98 = select(_e85, _e96, (_e96 < _e85));
let _e104 = global_3.member[bitcast<u32>(select(0i, _e98, (_e98 > 0i)))];
let _e107 = bitcast<i32>(((4u * _e80) + _e82));
let _e109 = select(_e85, _e107, (_e107 < _e85));
let _e115 = global_3.member[bitcast<u32>(select(0i, _e109, (_e109 > 0i)))];
let _e118 = bitcast<i32>(((5u * _e80) + _e82));
let _e120 = select(_e85, _e118, (_e118 < _e85));
let _e126 = global_3.member[bitcast<u32>(select(0i, _e120, (_e120 > 0i)))];
let _e129 = bitcast<i32>(((6u * _e80) + _e82));
let _e131 = select(_e85, _e129, (_e129 < _e85));
let _e137 = global_3.member[bitcast<u32>(select(0i, _e131, (_e131 > 0i)))];
let _e140 = bitcast<i32>(((7u * _e80) + _e82));
let _e142 = select(_e85, _e140, (_e140 < _e85));
let _e148 = global_3.member[bitcast<u32>(select(0i, _e142, (_e142 > 0i)))];
let _e151 = bitcast<i32>(((8u * _e80) + _e82));
let _e153 = select(_e85, _e151, (_e151 < _e85));
let _e159 = global_3.member[bitcast<u32>(select(0i, _e153, (_e153 > 0i)))];
let _e162 = bitcast<i32>(((9u * _e80) + _e82));
let _e164 = select(_e85, _e162, (_e162 < _e85));
let _e170 = global_3.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e173 = bitcast<i32>(((10u * _e80) + _e82));
let _e175 = select(_e85, _e173, (_e173 < _e85));
let _e181 = global_3.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
let _e184 = bitcast<i32>(((11u * _e80) + _e82));
let _e186 = select(_e85, _e184, (_e184 < _e85));
let _e192 = global_3.member[bitcast<u32>(select(0i, _e186, (_e186 > 0i)))];
let _e195 = bitcast<i32>(((12u * _e80) + _e82));
let _e197 = select(_e85, _e195, (_e195 < _e85));
let _e203 = global_3.member[bitcast<u32>(select(0i, _e197, (_e197 > 0i)))];
let _e206 = bitcast<i32>(((13u * _e80) + _e82));
let _e208 = select(_e85, _e206, (_e206 < _e85));
let _e214 = global_3.member[bitcast<u32>(select(0i, _e208, (_e208 > 0i)))];
let _e217 = bitcast<i32>(((14u * _e80) + _e82));
let _e219 = select(_e85, _e217, (_e217 < _e85));
let _e225 = global_3.member[bitcast<u32>(select(0i, _e219, (_e219 > 0i)))];
let _e228 = bitcast<i32>(((15u * _e80) + _e82));
let _e230 = select(_e85, _e228, (_e228 < _e85));
let _e236 = global_3.member[bitcast<u32>(select(0i, _e230, (_e230 > 0i)))];
let _e239 = bitcast<i32>(((16u * _e80) + _e82));
let _e241 = select(_e85, _e239, (_e239 < _e85));
let _e247 = global_3.member[bitcast<u32>(select(0i, _e241, (_e241 > 0i)))];
let _e250 = bitcast<i32>(((17u * _e80) + _e82));
let _e252 = select(_e85, _e250, (_e250 < _e85));
let _e258 = global_3.member[bitcast<u32>(select(0i, _e252, (_e252 > 0i)))];
let _e261 = bitcast<i32>(((18u * _e80) + _e82));
let _e263 = select(_e85, _e261, (_e261 < _e85));
let _e269 = global_3.member[bitcast<u32>(select(0i, _e263, (_e263 > 0i)))];
let _e270 = bitcast<i32>(_e53.x);
let _e271 = bitcast<i32>(_e53.y);
let _e275 = global_2.member.member_1.member;
let _e279 = global_2.member.member_1.member_1;
let _e280 = bitcast<i32>(_e275);
let _e282 = select(_e270, 0i, (_e270 < 0i));
let _e283 = (_e282 >= _e280);
if _e283 {
phi_531_ = (_e280 - 1i);
} else {
phi_531_ = _e282;
}
let _e286 = phi_531_;
let _e287 = bitcast<i32>(_e279);
let _e289 = select(_e271, 0i, (_e271 < 0i));
let _e290 = (_e289 >= _e287);
if _e290 {
phi_543_ = (_e287 - 1i);
} else {
phi_543_ = _e289;
}
let _e293 = phi_543_;
let _e296 = (((_e293 * _e280) + _e286) * 6i);
let _e298 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e300 = select(_e298, _e296, (_e296 < _e298));
let _e306 = global_4.member[bitcast<u32>(select(0i, _e300, (_e300 > 0i)))];
let _e307 = (_e296 + 1i);
let _e309 = select(_e298, _e307, (_e307 < _e298));
let _e315 = global_4.member[bitcast<u32>(select(0i, _e309, (_e309 > 0i)))];
let _e318 = ((_e315 >> bitcast<u32>(31i)) != 0u);
if _e318 {
phi_634_ = (~(_e306) + 1u);
} else {
phi_634_ = _e306;
}
let _e324 = phi_634_;
if _e318 {
phi_640_ = (~(_e315) + select(0u, 1u, (_e306 == 0u)));
} else {
phi_640_ = _e315;
}
let _e328 = phi_640_;
let _e350 = ((((f32(bitcast<i32>(((_e328 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e328 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e324 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e324 & 65535u)))));
let _e356 = (_e296 + 2i);
let _e358 = select(_e298, _e356, (_e356 < _e298));
let _e364 = global_4.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
let _e365 = (_e296 + 3i);
let _e367 = select(_e298, _e365, (_e365 < _e298));
let _e373 = global_4.member[bitcast<u32>(select(0i, _e367, (_e367 > 0i)))];
let _e376 = ((_e373 >> bitcast<u32>(31i)) != 0u);
if _e376 {
phi_702_ = (~(_e364) + 1u);
} else {
phi_702_ = _e364;
}
let _e382 = phi_702_;
if _e376 {
phi_708_ = (~(_e373) + select(0u, 1u, (_e364 == 0u)));
} else {
phi_708_ = _e373;
}
let _e386 = phi_708_;
let _e408 = ((((f32(bitcast<i32>(((_e386 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e386 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e382 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e382 & 65535u)))));
let _e414 = (_e296 + 4i);
let _e416 = select(_e298, _e414, (_e414 < _e298));
let _e422 = global_4.member[bitcast<u32>(select(0i, _e416, (_e416 > 0i)))];
let _e423 = (_e296 + 5i);
let _e425 = select(_e298, _e423, (_e423 < _e298));
let _e431 = global_4.member[bitcast<u32>(select(0i, _e425, (_e425 > 0i)))];
let _e434 = ((_e431 >> bitcast<u32>(31i)) != 0u);
if _e434 {
phi_770_ = (~(_e422) + 1u);
} else {
phi_770_ = _e422;
}
let _e440 = phi_770_;
if _e434 {
phi_776_ = (~(_e431) + select(0u, 1u, (_e422 == 0u)));
} else {
phi_776_ = _e431;
}
let _e444 = phi_776_;
let _e466 = ((((f32(bitcast<i32>(((_e444 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e444 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e440 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e440 & 65535u)))));
phi_799_ = vec3<f32>(select(_e350, -(bitcast<f32>((bitcast<u32>(_e350) & 2147483647u))), _e318), select(_e408, -(bitcast<f32>((bitcast<u32>(_e408) & 2147483647u))), _e376), select(_e466, -(bitcast<f32>((bitcast<u32>(_e466) & 2147483647u))), _e434));
phi_802_ = 1u;
loop {
let _e474 = phi_799_;
let _e476 = phi_802_;
local = _e474;
local_1 = _e474;
local_2 = _e474;
let _e480 = global_2.member.member_18.member_1;
let _e481 = (_e476 <= _e480);
local_3 = _e480;
if _e481 {
let _e482 = (_e476 & 31u);
let _e486 = (1f / f32((1i << bitcast<u32>(_e482))));
let _e490 = (((f32(_e270) + 0.5f) * _e486) - 0.5f);
let _e494 = (((f32(_e271) + 0.5f) * _e486) - 0.5f);
let _e496 = select(-1f, _e490, (_e490 > -1f));
let _e498 = select(1e6f, _e496, (_e496 < 1e6f));
let _e505 = select(0i, select(select(i32(_e498), i32(-2147483648), (_e498 < -2147483600f)), 2147483647i, (_e498 > 2147483500f)), (_e498 == _e498));
let _e509 = (_e505 - select(0i, 1i, (_e498 < f32(_e505))));
let _e511 = select(-1f, _e494, (_e494 > -1f));
let _e513 = select(1e6f, _e511, (_e511 < 1e6f));
let _e520 = select(0i, select(select(i32(_e513), i32(-2147483648), (_e513 < -2147483600f)), 2147483647i, (_e513 > 2147483500f)), (_e513 == _e513));
let _e524 = (_e520 - select(0i, 1i, (_e513 < f32(_e520))));
let _e526 = (_e490 - f32(_e509));
let _e528 = (_e494 - f32(_e524));
let _e530 = (1u << bitcast<u32>(_e482));
let _e539 = bitcast<i32>((((_e275 + _e530) - 1u) >> bitcast<u32>(_e482)));
let _e541 = select(_e509, 0i, (_e509 < 0i));
let _e542 = (_e541 >= _e539);
if _e542 {
phi_903_ = (_e539 - 1i);
} else {
phi_903_ = _e541;
}
let _e545 = phi_903_;
let _e546 = bitcast<i32>((((_e279 + _e530) - 1u) >> bitcast<u32>(_e482)));
let _e548 = select(_e524, 0i, (_e524 < 0i));
let _e549 = (_e548 >= _e546);
if _e549 {
phi_915_ = (_e546 - 1i);
} else {
phi_915_ = _e548;
}
let _e552 = phi_915_;
let _e556 = global_2.member.member_18.member_2;
let _e560 = global_2.member.member_18.member_3;
let _e564 = global_2.member.member_18.member_4;
let _e568 = global_2.member.member_18.member_5;
let _e569 = (_e476 == 0u);
if _e569 {
phi_947_ = 0u;
} else {
if (_e476 == 1u) {
phi_946_ = _e556;
} else {
if (_e476 == 2u) {
phi_945_ = _e560;
} else {
phi_945_ = select(_e568, _e564, (_e476 == 3u));
}
let _e575 = phi_945_;
phi_946_ = _e575;
}
let _e577 = phi_946_;
phi_947_ = _e577;
}
let _e579 = phi_947_;
let _e584 = (((bitcast<i32>(_e579) + (_e552 * _e539)) + _e545) * 6i);
let _e586 = select(_e298, _e584, (_e584 < _e298));
let _e592 = global_4.member[bitcast<u32>(select(0i, _e586, (_e586 > 0i)))];
let _e593 = (_e584 + 1i);
let _e595 = select(_e298, _e593, (_e593 < _e298));
let _e601 = global_4.member[bitcast<u32>(select(0i, _e595, (_e595 > 0i)))];
let _e604 = ((_e601 >> bitcast<u32>(31i)) != 0u);
if _e604 {
phi_1006_ = (~(_e592) + 1u);
} else {
phi_1006_ = _e592;
}
let _e610 = phi_1006_;
if _e604 {
phi_1012_ = (~(_e601) + select(0u, 1u, (_e592 == 0u)));
} else {
phi_1012_ = _e601;
}
let _e614 = phi_1012_;
let _e636 = ((((f32(bitcast<i32>(((_e614 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e614 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e610 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e610 & 65535u)))));
let _e642 = (_e584 + 2i);
let _e644 = select(_e298, _e642, (_e642 < _e298));
let _e650 = global_4.member[bitcast<u32>(select(0i, _e644, (_e644 > 0i)))];
let _e651 = (_e584 + 3i);
let _e653 = select(_e298, _e651, (_e651 < _e298));
let _e659 = global_4.member[bitcast<u32>(select(0i, _e653, (_e653 > 0i)))];
let _e662 = ((_e659 >> bitcast<u32>(31i)) != 0u);
if _e662 {
phi_1074_ = (~(_e650) + 1u);
} else {
phi_1074_ = _e650;
}
let _e668 = phi_1074_;
if _e662 {
phi_1080_ = (~(_e659) + select(0u, 1u, (_e650 == 0u)));
} else {
phi_1080_ = _e659;
}
let _e672 = phi_1080_;
let _e694 = ((((f32(bitcast<i32>(((_e672 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e672 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e668 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e668 & 65535u)))));
let _e700 = (_e584 + 4i);
let _e702 = select(_e298, _e700, (_e700 < _e298));
let _e708 = global_4.member[bitcast<u32>(select(0i, _e702, (_e702 > 0i)))];
let _e709 = (_e584 + 5i);
let _e711 = select(_e298, _e709, (_e709 < _e298));
let _e717 = global_4.member[bitcast<u32>(select(0i, _e711, (_e711 > 0i)))];
let _e720 = ((_e717 >> bitcast<u32>(31i)) != 0u);
if _e720 {
phi_1142_ = (~(_e708) + 1u);
} else {
phi_1142_ = _e708;
}
let _e726 = phi_1142_;
if _e720 {
phi_1148_ = (~(_e717) + select(0u, 1u, (_e708 == 0u)));
} else {
phi_1148_ = _e717;
}
let _e730 = phi_1148_;
let _e752 = ((((f32(bitcast<i32>(((_e730 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e730 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e726 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e726 & 65535u)))));
let _e758 = (1f - _e526);
let _e762 = (_e509 + 1i);
let _e764 = select(_e762, 0i, (_e762 < 0i));
let _e765 = (_e764 >= _e539);
if _e765 {
phi_1202_ = (_e539 - 1i);
} else {
phi_1202_ = _e764;
}
let _e768 = phi_1202_;
if _e549 {
phi_1214_ = (_e546 - 1i);
} else {
phi_1214_ = _e548;
}
let _e771 = phi_1214_;
if _e569 {
phi_1246_ = 0u;
} else {
if (_e476 == 1u) {
phi_1245_ = _e556;
} else {
if (_e476 == 2u) {
phi_1244_ = _e560;
} else {
phi_1244_ = select(_e568, _e564, (_e476 == 3u));
}
let _e777 = phi_1244_;
phi_1245_ = _e777;
}
let _e779 = phi_1245_;
phi_1246_ = _e779;
}
let _e781 = phi_1246_;
let _e786 = (((bitcast<i32>(_e781) + (_e771 * _e539)) + _e768) * 6i);
let _e788 = select(_e298, _e786, (_e786 < _e298));
let _e794 = global_4.member[bitcast<u32>(select(0i, _e788, (_e788 > 0i)))];
let _e795 = (_e786 + 1i);
let _e797 = select(_e298, _e795, (_e795 < _e298));
let _e803 = global_4.member[bitcast<u32>(select(0i, _e797, (_e797 > 0i)))];
let _e806 = ((_e803 >> bitcast<u32>(31i)) != 0u);
if _e806 {
phi_1305_ = (~(_e794) + 1u);
} else {
phi_1305_ = _e794;
}
let _e812 = phi_1305_;
if _e806 {
phi_1311_ = (~(_e803) + select(0u, 1u, (_e794 == 0u)));
} else {
phi_1311_ = _e803;
}
let _e816 = phi_1311_;
let _e838 = ((((f32(bitcast<i32>(((_e816 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e816 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e812 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e812 & 65535u)))));
let _e844 = (_e786 + 2i);
let _e846 = select(_e298, _e844, (_e844 < _e298));
let _e852 = global_4.member[bitcast<u32>(select(0i, _e846, (_e846 > 0i)))];
let _e853 = (_e786 + 3i);
let _e855 = select(_e298, _e853, (_e853 < _e298));
let _e861 = global_4.member[bitcast<u32>(select(0i, _e855, (_e855 > 0i)))];
let _e864 = ((_e861 >> bitcast<u32>(31i)) != 0u);
if _e864 {
phi_1373_ = (~(_e852) + 1u);
} else {
phi_1373_ = _e852;
}
let _e870 = phi_1373_;
if _e864 {
phi_1379_ = (~(_e861) + select(0u, 1u, (_e852 == 0u)));
} else {
phi_1379_ = _e861;
}
let _e874 = phi_1379_;
let _e896 = ((((f32(bitcast<i32>(((_e874 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e874 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e870 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e870 & 65535u)))));
let _e902 = (_e786 + 4i);
let _e904 = select(_e298, _e902, (_e902 < _e298));
let _e910 = global_4.member[bitcast<u32>(select(0i, _e904, (_e904 > 0i)))];
let _e911 = (_e786 + 5i);
let _e913 = select(_e298, _e911, (_e911 < _e298));
let _e919 = global_4.member[bitcast<u32>(select(0i, _e913, (_e913 > 0i)))];
let _e922 = ((_e919 >> bitcast<u32>(31i)) != 0u);
if _e922 {
phi_1441_ = (~(_e910) + 1u);
} else {
phi_1441_ = _e910;
}
let _e928 = phi_1441_;
if _e922 {
phi_1447_ = (~(_e919) + select(0u, 1u, (_e910 == 0u)));
} else {
phi_1447_ = _e919;
}
let _e932 = phi_1447_;
let _e954 = ((((f32(bitcast<i32>(((_e932 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e932 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e928 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e928 & 65535u)))));
let _e966 = (_e524 + 1i);
if _e542 {
phi_1503_ = (_e539 - 1i);
} else {
phi_1503_ = _e541;
}
let _e969 = phi_1503_;
let _e971 = select(_e966, 0i, (_e966 < 0i));
let _e972 = (_e971 >= _e546);
if _e972 {
phi_1515_ = (_e546 - 1i);
} else {
phi_1515_ = _e971;
}
let _e975 = phi_1515_;
if _e569 {
phi_1547_ = 0u;
} else {
if (_e476 == 1u) {
phi_1546_ = _e556;
} else {
if (_e476 == 2u) {
phi_1545_ = _e560;
} else {
phi_1545_ = select(_e568, _e564, (_e476 == 3u));
}
let _e981 = phi_1545_;
phi_1546_ = _e981;
}
let _e983 = phi_1546_;
phi_1547_ = _e983;
}
let _e985 = phi_1547_;
let _e990 = (((bitcast<i32>(_e985) + (_e975 * _e539)) + _e969) * 6i);
let _e992 = select(_e298, _e990, (_e990 < _e298));
let _e998 = global_4.member[bitcast<u32>(select(0i, _e992, (_e992 > 0i)))];
let _e999 = (_e990 + 1i);
let _e1001 = select(_e298, _e999, (_e999 < _e298));
let _e1007 = global_4.member[bitcast<u32>(select(0i, _e1001, (_e1001 > 0i)))];
let _e1010 = ((_e1007 >> bitcast<u32>(31i)) != 0u);
if _e1010 {
phi_1606_ = (~(_e998) + 1u);
} else {
phi_1606_ = _e998;
}
let _e1016 = phi_1606_;
if _e1010 {
phi_1612_ = (~(_e1007) + select(0u, 1u, (_e998 == 0u)));
} else {
phi_1612_ = _e1007;
}
let _e1020 = phi_1612_;
let _e1042 = ((((f32(bitcast<i32>(((_e1020 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1020 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1016 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1016 & 65535u)))));
let _e1048 = (_e990 + 2i);
let _e1050 = select(_e298, _e1048, (_e1048 < _e298));
let _e1056 = global_4.member[bitcast<u32>(select(0i, _e1050, (_e1050 > 0i)))];
let _e1057 = (_e990 + 3i);
let _e1059 = select(_e298, _e1057, (_e1057 < _e298));
let _e1065 = global_4.member[bitcast<u32>(select(0i, _e1059, (_e1059 > 0i)))];
let _e1068 = ((_e1065 >> bitcast<u32>(31i)) != 0u);
if _e1068 {
phi_1674_ = (~(_e1056) + 1u);
} else {
phi_1674_ = _e1056;
}
let _e1074 = phi_1674_;
if _e1068 {
phi_1680_ = (~(_e1065) + select(0u, 1u, (_e1056 == 0u)));
} else {
phi_1680_ = _e1065;
}
let _e1078 = phi_1680_;
let _e1100 = ((((f32(bitcast<i32>(((_e1078 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1078 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1074 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1074 & 65535u)))));
let _e1106 = (_e990 + 4i);
let _e1108 = select(_e298, _e1106, (_e1106 < _e298));
let _e1114 = global_4.member[bitcast<u32>(select(0i, _e1108, (_e1108 > 0i)))];
let _e1115 = (_e990 + 5i);
let _e1117 = select(_e298, _e1115, (_e1115 < _e298));
let _e1123 = global_4.member[bitcast<u32>(select(0i, _e1117, (_e1117 > 0i)))];
let _e1126 = ((_e1123 >> bitcast<u32>(31i)) != 0u);
if _e1126 {
phi_1742_ = (~(_e1114) + 1u);
} else {
phi_1742_ = _e1114;
}
let _e1132 = phi_1742_;
if _e1126 {
phi_1748_ = (~(_e1123) + select(0u, 1u, (_e1114 == 0u)));
} else {
phi_1748_ = _e1123;
}
let _e1136 = phi_1748_;
let _e1158 = ((((f32(bitcast<i32>(((_e1136 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1136 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1132 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1132 & 65535u)))));
if _e765 {
phi_1803_ = (_e539 - 1i);
} else {
phi_1803_ = _e764;
}
let _e1169 = phi_1803_;
if _e972 {
phi_1815_ = (_e546 - 1i);
} else {
phi_1815_ = _e971;
}
let _e1172 = phi_1815_;
if _e569 {
phi_1847_ = 0u;
} else {
if (_e476 == 1u) {
phi_1846_ = _e556;
} else {
if (_e476 == 2u) {
phi_1845_ = _e560;
} else {
phi_1845_ = select(_e568, _e564, (_e476 == 3u));
}
let _e1178 = phi_1845_;
phi_1846_ = _e1178;
}
let _e1180 = phi_1846_;
phi_1847_ = _e1180;
}
let _e1182 = phi_1847_;
let _e1187 = (((bitcast<i32>(_e1182) + (_e1172 * _e539)) + _e1169) * 6i);
let _e1189 = select(_e298, _e1187, (_e1187 < _e298));
let _e1195 = global_4.member[bitcast<u32>(select(0i, _e1189, (_e1189 > 0i)))];
let _e1196 = (_e1187 + 1i);
let _e1198 = select(_e298, _e1196, (_e1196 < _e298));
let _e1204 = global_4.member[bitcast<u32>(select(0i, _e1198, (_e1198 > 0i)))];
let _e1207 = ((_e1204 >> bitcast<u32>(31i)) != 0u);
if _e1207 {
phi_1906_ = (~(_e1195) + 1u);
} else {
phi_1906_ = _e1195;
}
let _e1213 = phi_1906_;
if _e1207 {
phi_1912_ = (~(_e1204) + select(0u, 1u, (_e1195 == 0u)));
} else {
phi_1912_ = _e1204;
}
let _e1217 = phi_1912_;
let _e1239 = ((((f32(bitcast<i32>(((_e1217 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1217 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1213 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1213 & 65535u)))));
let _e1245 = (_e1187 + 2i);
let _e1247 = select(_e298, _e1245, (_e1245 < _e298));
let _e1253 = global_4.member[bitcast<u32>(select(0i, _e1247, (_e1247 > 0i)))];
let _e1254 = (_e1187 + 3i);
let _e1256 = select(_e298, _e1254, (_e1254 < _e298));
let _e1262 = global_4.member[bitcast<u32>(select(0i, _e1256, (_e1256 > 0i)))];
let _e1265 = ((_e1262 >> bitcast<u32>(31i)) != 0u);
if _e1265 {
phi_1974_ = (~(_e1253) + 1u);
} else {
phi_1974_ = _e1253;
}
let _e1271 = phi_1974_;
if _e1265 {
phi_1980_ = (~(_e1262) + select(0u, 1u, (_e1253 == 0u)));
} else {
phi_1980_ = _e1262;
}
let _e1275 = phi_1980_;
let _e1297 = ((((f32(bitcast<i32>(((_e1275 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1275 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1271 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1271 & 65535u)))));
let _e1303 = (_e1187 + 4i);
let _e1305 = select(_e298, _e1303, (_e1303 < _e298));
let _e1311 = global_4.member[bitcast<u32>(select(0i, _e1305, (_e1305 > 0i)))];
let _e1312 = (_e1187 + 5i);
let _e1314 = select(_e298, _e1312, (_e1312 < _e298));
let _e1320 = global_4.member[bitcast<u32>(select(0i, _e1314, (_e1314 > 0i)))];
let _e1323 = ((_e1320 >> bitcast<u32>(31i)) != 0u);
if _e1323 {
phi_2042_ = (~(_e1311) + 1u);
} else {
phi_2042_ = _e1311;
}
let _e1329 = phi_2042_;
if _e1323 {
phi_2048_ = (~(_e1320) + select(0u, 1u, (_e1311 == 0u)));
} else {
phi_2048_ = _e1320;
}
let _e1333 = phi_2048_;
let _e1355 = ((((f32(bitcast<i32>(((_e1333 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1333 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1329 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1329 & 65535u)))));
let _e1367 = (1f - _e528);
phi_800_ = vec3<f32>((_e474.x + ((((select(_e636, -(bitcast<f32>((bitcast<u32>(_e636) & 2147483647u))), _e604) * _e758) + (select(_e838, -(bitcast<f32>((bitcast<u32>(_e838) & 2147483647u))), _e806) * _e526)) * _e1367) + (((select(_e1042, -(bitcast<f32>((bitcast<u32>(_e1042) & 2147483647u))), _e1010) * _e758) + (select(_e1239, -(bitcast<f32>((bitcast<u32>(_e1239) & 2147483647u))), _e1207) * _e526)) * _e528))), (_e474.y + ((((select(_e694, -(bitcast<f32>((bitcast<u32>(_e694) & 2147483647u))), _e662) * _e758) + (select(_e896, -(bitcast<f32>((bitcast<u32>(_e896) & 2147483647u))), _e864) * _e526)) * _e1367) + (((select(_e1100, -(bitcast<f32>((bitcast<u32>(_e1100) & 2147483647u))), _e1068) * _e758) + (select(_e1297, -(bitcast<f32>((bitcast<u32>(_e1297) & 2147483647u))), _e1265) * _e526)) * _e528))), (_e474.z + ((((select(_e752, -(bitcast<f32>((bitcast<u32>(_e752) & 2147483647u))), _e720) * _e758) + (select(_e954, -(bitcast<f32>((bitcast<u32>(_e954) & 2147483647u))), _e922) * _e526)) * _e1367) + (((select(_e1158, -(bitcast<f32>((bitcast<u32>(_e1158) & 2147483647u))), _e1126) * _e758) + (select(_e1355, -(bitcast<f32>((bitcast<u32>(_e1355) & 2147483647u))), _e1323) * _e526)) * _e528))));
phi_803_ = (_e476 + 1u);
} else {
phi_800_ = vec3<f32>();
phi_803_ = u32();
}
let _e1386 = phi_800_;
let _e1388 = phi_803_;
continue;
continuing {
phi_799_ = _e1386;
phi_802_ = _e1388;
break if !(_e481);
}
}
let _e1393 = global_2.member.member_18.member;
let _e1394 = (1f / _e1393);
let _e1396 = local;
let _e1400 = local_1;
let _e1404 = local_2;
let _e1407 = ((_e1396.x * _e1394) + _e170);
let _e1408 = ((_e1400.y * _e1394) + _e181);
let _e1409 = ((_e1404.z * _e1394) + _e192);
if _e283 {
phi_2138_ = (_e280 - 1i);
} else {
phi_2138_ = _e282;
}
let _e1412 = phi_2138_;
if _e290 {
phi_2150_ = (_e287 - 1i);
} else {
phi_2150_ = _e289;
}
let _e1415 = phi_2150_;
let _e1418 = (((_e1415 * _e280) + _e1412) * 6i);
let _e1420 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1422 = select(_e1420, _e1418, (_e1418 < _e1420));
let _e1428 = global_5.member[bitcast<u32>(select(0i, _e1422, (_e1422 > 0i)))];
let _e1429 = (_e1418 + 1i);
let _e1431 = select(_e1420, _e1429, (_e1429 < _e1420));
let _e1437 = global_5.member[bitcast<u32>(select(0i, _e1431, (_e1431 > 0i)))];
let _e1440 = ((_e1437 >> bitcast<u32>(31i)) != 0u);
if _e1440 {
phi_2241_ = (~(_e1428) + 1u);
} else {
phi_2241_ = _e1428;
}
let _e1446 = phi_2241_;
if _e1440 {
phi_2247_ = (~(_e1437) + select(0u, 1u, (_e1428 == 0u)));
} else {
phi_2247_ = _e1437;
}
let _e1450 = phi_2247_;
let _e1472 = ((((f32(bitcast<i32>(((_e1450 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1450 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1446 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1446 & 65535u)))));
let _e1478 = (_e1418 + 2i);
let _e1480 = select(_e1420, _e1478, (_e1478 < _e1420));
let _e1486 = global_5.member[bitcast<u32>(select(0i, _e1480, (_e1480 > 0i)))];
let _e1487 = (_e1418 + 3i);
let _e1489 = select(_e1420, _e1487, (_e1487 < _e1420));
let _e1495 = global_5.member[bitcast<u32>(select(0i, _e1489, (_e1489 > 0i)))];
let _e1498 = ((_e1495 >> bitcast<u32>(31i)) != 0u);
if _e1498 {
phi_2309_ = (~(_e1486) + 1u);
} else {
phi_2309_ = _e1486;
}
let _e1504 = phi_2309_;
if _e1498 {
phi_2315_ = (~(_e1495) + select(0u, 1u, (_e1486 == 0u)));
} else {
phi_2315_ = _e1495;
}
let _e1508 = phi_2315_;
let _e1530 = ((((f32(bitcast<i32>(((_e1508 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1508 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1504 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1504 & 65535u)))));
let _e1536 = (_e1418 + 4i);
let _e1538 = select(_e1420, _e1536, (_e1536 < _e1420));
let _e1544 = global_5.member[bitcast<u32>(select(0i, _e1538, (_e1538 > 0i)))];
let _e1545 = (_e1418 + 5i);
let _e1547 = select(_e1420, _e1545, (_e1545 < _e1420));
let _e1553 = global_5.member[bitcast<u32>(select(0i, _e1547, (_e1547 > 0i)))];
let _e1556 = ((_e1553 >> bitcast<u32>(31i)) != 0u);
if _e1556 {
phi_2377_ = (~(_e1544) + 1u);
} else {
phi_2377_ = _e1544;
}
let _e1562 = phi_2377_;
if _e1556 {
phi_2383_ = (~(_e1553) + select(0u, 1u, (_e1544 == 0u)));
} else {
phi_2383_ = _e1553;
}
let _e1566 = phi_2383_;
let _e1588 = ((((f32(bitcast<i32>(((_e1566 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1566 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1562 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1562 & 65535u)))));
phi_2406_ = vec3<f32>(select(_e1472, -(bitcast<f32>((bitcast<u32>(_e1472) & 2147483647u))), _e1440), select(_e1530, -(bitcast<f32>((bitcast<u32>(_e1530) & 2147483647u))), _e1498), select(_e1588, -(bitcast<f32>((bitcast<u32>(_e1588) & 2147483647u))), _e1556));
phi_2409_ = 1u;
loop {
let _e1596 = phi_2406_;
let _e1598 = phi_2409_;
local_4 = _e1596;
local_5 = _e1596;
local_6 = _e1596;
let _e1600 = local_3;
let _e1601 = (_e1598 <= _e1600);
if _e1601 {
let _e1602 = (_e1598 & 31u);
let _e1606 = (1f / f32((1i << bitcast<u32>(_e1602))));
let _e1610 = (((f32(_e270) + 0.5f) * _e1606) - 0.5f);
let _e1614 = (((f32(_e271) + 0.5f) * _e1606) - 0.5f);
let _e1616 = select(-1f, _e1610, (_e1610 > -1f));
let _e1618 = select(1e6f, _e1616, (_e1616 < 1e6f));
let _e1625 = select(0i, select(select(i32(_e1618), i32(-2147483648), (_e1618 < -2147483600f)), 2147483647i, (_e1618 > 2147483500f)), (_e1618 == _e1618));
let _e1629 = (_e1625 - select(0i, 1i, (_e1618 < f32(_e1625))));
let _e1631 = select(-1f, _e1614, (_e1614 > -1f));
let _e1633 = select(1e6f, _e1631, (_e1631 < 1e6f));
let _e1640 = select(0i, select(select(i32(_e1633), i32(-2147483648), (_e1633 < -2147483600f)), 2147483647i, (_e1633 > 2147483500f)), (_e1633 == _e1633));
let _e1644 = (_e1640 - select(0i, 1i, (_e1633 < f32(_e1640))));
let _e1646 = (_e1610 - f32(_e1629));
let _e1648 = (_e1614 - f32(_e1644));
let _e1650 = (1u << bitcast<u32>(_e1602));
let _e1659 = bitcast<i32>((((_e275 + _e1650) - 1u) >> bitcast<u32>(_e1602)));
let _e1661 = select(_e1629, 0i, (_e1629 < 0i));
let _e1662 = (_e1661 >= _e1659);
if _e1662 {
phi_2510_ = (_e1659 - 1i);
} else {
phi_2510_ = _e1661;
}
let _e1665 = phi_2510_;
let _e1666 = bitcast<i32>((((_e279 + _e1650) - 1u) >> bitcast<u32>(_e1602)));
let _e1668 = select(_e1644, 0i, (_e1644 < 0i));
let _e1669 = (_e1668 >= _e1666);
if _e1669 {
phi_2522_ = (_e1666 - 1i);
} else {
phi_2522_ = _e1668;
}
let _e1672 = phi_2522_;
let _e1676 = global_2.member.member_18.member_2;
let _e1680 = global_2.member.member_18.member_3;
let _e1684 = global_2.member.member_18.member_4;
let _e1688 = global_2.member.member_18.member_5;
let _e1689 = (_e1598 == 0u);
if _e1689 {
phi_2554_ = 0u;
} else {
if (_e1598 == 1u) {
phi_2553_ = _e1676;
} else {
if (_e1598 == 2u) {
phi_2552_ = _e1680;
} else {
phi_2552_ = select(_e1688, _e1684, (_e1598 == 3u));
}
let _e1695 = phi_2552_;
phi_2553_ = _e1695;
}
let _e1697 = phi_2553_;
phi_2554_ = _e1697;
}
let _e1699 = phi_2554_;
let _e1704 = (((bitcast<i32>(_e1699) + (_e1672 * _e1659)) + _e1665) * 6i);
let _e1706 = select(_e1420, _e1704, (_e1704 < _e1420));
let _e1712 = global_5.member[bitcast<u32>(select(0i, _e1706, (_e1706 > 0i)))];
let _e1713 = (_e1704 + 1i);
let _e1715 = select(_e1420, _e1713, (_e1713 < _e1420));
let _e1721 = global_5.member[bitcast<u32>(select(0i, _e1715, (_e1715 > 0i)))];
let _e1724 = ((_e1721 >> bitcast<u32>(31i)) != 0u);
if _e1724 {
phi_2613_ = (~(_e1712) + 1u);
} else {
phi_2613_ = _e1712;
}
let _e1730 = phi_2613_;
if _e1724 {
phi_2619_ = (~(_e1721) + select(0u, 1u, (_e1712 == 0u)));
} else {
phi_2619_ = _e1721;
}
let _e1734 = phi_2619_;
let _e1756 = ((((f32(bitcast<i32>(((_e1734 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1734 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1730 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1730 & 65535u)))));
let _e1762 = (_e1704 + 2i);
let _e1764 = select(_e1420, _e1762, (_e1762 < _e1420));
let _e1770 = global_5.member[bitcast<u32>(select(0i, _e1764, (_e1764 > 0i)))];
let _e1771 = (_e1704 + 3i);
let _e1773 = select(_e1420, _e1771, (_e1771 < _e1420));
let _e1779 = global_5.member[bitcast<u32>(select(0i, _e1773, (_e1773 > 0i)))];
let _e1782 = ((_e1779 >> bitcast<u32>(31i)) != 0u);
if _e1782 {
phi_2681_ = (~(_e1770) + 1u);
} else {
phi_2681_ = _e1770;
}
let _e1788 = phi_2681_;
if _e1782 {
phi_2687_ = (~(_e1779) + select(0u, 1u, (_e1770 == 0u)));
} else {
phi_2687_ = _e1779;
}
let _e1792 = phi_2687_;
let _e1814 = ((((f32(bitcast<i32>(((_e1792 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1792 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1788 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1788 & 65535u)))));
let _e1820 = (_e1704 + 4i);
let _e1822 = select(_e1420, _e1820, (_e1820 < _e1420));
let _e1828 = global_5.member[bitcast<u32>(select(0i, _e1822, (_e1822 > 0i)))];
let _e1829 = (_e1704 + 5i);
let _e1831 = select(_e1420, _e1829, (_e1829 < _e1420));
let _e1837 = global_5.member[bitcast<u32>(select(0i, _e1831, (_e1831 > 0i)))];
let _e1840 = ((_e1837 >> bitcast<u32>(31i)) != 0u);
if _e1840 {
phi_2749_ = (~(_e1828) + 1u);
} else {
phi_2749_ = _e1828;
}
let _e1846 = phi_2749_;
if _e1840 {
phi_2755_ = (~(_e1837) + select(0u, 1u, (_e1828 == 0u)));
} else {
phi_2755_ = _e1837;
}
let _e1850 = phi_2755_;
let _e1872 = ((((f32(bitcast<i32>(((_e1850 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1850 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1846 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1846 & 65535u)))));
let _e1878 = (1f - _e1646);
let _e1882 = (_e1629 + 1i);
let _e1884 = select(_e1882, 0i, (_e1882 < 0i));
let _e1885 = (_e1884 >= _e1659);
if _e1885 {
phi_2809_ = (_e1659 - 1i);
} else {
phi_2809_ = _e1884;
}
let _e1888 = phi_2809_;
if _e1669 {
phi_2821_ = (_e1666 - 1i);
} else {
phi_2821_ = _e1668;
}
let _e1891 = phi_2821_;
if _e1689 {
phi_2853_ = 0u;
} else {
if (_e1598 == 1u) {
phi_2852_ = _e1676;
} else {
if (_e1598 == 2u) {
phi_2851_ = _e1680;
} else {
phi_2851_ = select(_e1688, _e1684, (_e1598 == 3u));
}
let _e1897 = phi_2851_;
phi_2852_ = _e1897;
}
let _e1899 = phi_2852_;
phi_2853_ = _e1899;
}
let _e1901 = phi_2853_;
let _e1906 = (((bitcast<i32>(_e1901) + (_e1891 * _e1659)) + _e1888) * 6i);
let _e1908 = select(_e1420, _e1906, (_e1906 < _e1420));
let _e1914 = global_5.member[bitcast<u32>(select(0i, _e1908, (_e1908 > 0i)))];
let _e1915 = (_e1906 + 1i);
let _e1917 = select(_e1420, _e1915, (_e1915 < _e1420));
let _e1923 = global_5.member[bitcast<u32>(select(0i, _e1917, (_e1917 > 0i)))];
let _e1926 = ((_e1923 >> bitcast<u32>(31i)) != 0u);
if _e1926 {
phi_2912_ = (~(_e1914) + 1u);
} else {
phi_2912_ = _e1914;
}
let _e1932 = phi_2912_;
if _e1926 {
phi_2918_ = (~(_e1923) + select(0u, 1u, (_e1914 == 0u)));
} else {
phi_2918_ = _e1923;
}
let _e1936 = phi_2918_;
let _e1958 = ((((f32(bitcast<i32>(((_e1936 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1936 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1932 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1932 & 65535u)))));
let _e1964 = (_e1906 + 2i);
let _e1966 = select(_e1420, _e1964, (_e1964 < _e1420));
let _e1972 = global_5.member[bitcast<u32>(select(0i, _e1966, (_e1966 > 0i)))];
let _e1973 = (_e1906 + 3i);
let _e1975 = select(_e1420, _e1973, (_e1973 < _e1420));
let _e1981 = global_5.member[bitcast<u32>(select(0i, _e1975, (_e1975 > 0i)))];
let _e1984 = ((_e1981 >> bitcast<u32>(31i)) != 0u);
if _e1984 {
phi_2980_ = (~(_e1972) + 1u);
} else {
phi_2980_ = _e1972;
}
let _e1990 = phi_2980_;
if _e1984 {
phi_2986_ = (~(_e1981) + select(0u, 1u, (_e1972 == 0u)));
} else {
phi_2986_ = _e1981;
}
let _e1994 = phi_2986_;
let _e2016 = ((((f32(bitcast<i32>(((_e1994 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1994 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1990 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1990 & 65535u)))));
let _e2022 = (_e1906 + 4i);
let _e2024 = select(_e1420, _e2022, (_e2022 < _e1420));
let _e2030 = global_5.member[bitcast<u32>(select(0i, _e2024, (_e2024 > 0i)))];
let _e2031 = (_e1906 + 5i);
let _e2033 = select(_e1420, _e2031, (_e2031 < _e1420));
let _e2039 = global_5.member[bitcast<u32>(select(0i, _e2033, (_e2033 > 0i)))];
let _e2042 = ((_e2039 >> bitcast<u32>(31i)) != 0u);
if _e2042 {
phi_3048_ = (~(_e2030) + 1u);
} else {
phi_3048_ = _e2030;
}
let _e2048 = phi_3048_;
if _e2042 {
phi_3054_ = (~(_e2039) + select(0u, 1u, (_e2030 == 0u)));
} else {
phi_3054_ = _e2039;
}
let _e2052 = phi_3054_;
let _e2074 = ((((f32(bitcast<i32>(((_e2052 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2052 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2048 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2048 & 65535u)))));
let _e2086 = (_e1644 + 1i);
if _e1662 {
phi_3110_ = (_e1659 - 1i);
} else {
phi_3110_ = _e1661;
}
let _e2089 = phi_3110_;
let _e2091 = select(_e2086, 0i, (_e2086 < 0i));
let _e2092 = (_e2091 >= _e1666);
if _e2092 {
phi_3122_ = (_e1666 - 1i);
} else {
phi_3122_ = _e2091;
}
let _e2095 = phi_3122_;
if _e1689 {
phi_3154_ = 0u;
} else {
if (_e1598 == 1u) {
phi_3153_ = _e1676;
} else {
if (_e1598 == 2u) {
phi_3152_ = _e1680;
} else {
phi_3152_ = select(_e1688, _e1684, (_e1598 == 3u));
}
let _e2101 = phi_3152_;
phi_3153_ = _e2101;
}
let _e2103 = phi_3153_;
phi_3154_ = _e2103;
}
let _e2105 = phi_3154_;
let _e2110 = (((bitcast<i32>(_e2105) + (_e2095 * _e1659)) + _e2089) * 6i);
let _e2112 = select(_e1420, _e2110, (_e2110 < _e1420));
let _e2118 = global_5.member[bitcast<u32>(select(0i, _e2112, (_e2112 > 0i)))];
let _e2119 = (_e2110 + 1i);
let _e2121 = select(_e1420, _e2119, (_e2119 < _e1420));
let _e2127 = global_5.member[bitcast<u32>(select(0i, _e2121, (_e2121 > 0i)))];
let _e2130 = ((_e2127 >> bitcast<u32>(31i)) != 0u);
if _e2130 {
phi_3213_ = (~(_e2118) + 1u);
} else {
phi_3213_ = _e2118;
}
let _e2136 = phi_3213_;
if _e2130 {
phi_3219_ = (~(_e2127) + select(0u, 1u, (_e2118 == 0u)));
} else {
phi_3219_ = _e2127;
}
let _e2140 = phi_3219_;
let _e2162 = ((((f32(bitcast<i32>(((_e2140 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2140 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2136 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2136 & 65535u)))));
let _e2168 = (_e2110 + 2i);
let _e2170 = select(_e1420, _e2168, (_e2168 < _e1420));
let _e2176 = global_5.member[bitcast<u32>(select(0i, _e2170, (_e2170 > 0i)))];
let _e2177 = (_e2110 + 3i);
let _e2179 = select(_e1420, _e2177, (_e2177 < _e1420));
let _e2185 = global_5.member[bitcast<u32>(select(0i, _e2179, (_e2179 > 0i)))];
let _e2188 = ((_e2185 >> bitcast<u32>(31i)) != 0u);
if _e2188 {
phi_3281_ = (~(_e2176) + 1u);
} else {
phi_3281_ = _e2176;
}
let _e2194 = phi_3281_;
if _e2188 {
phi_3287_ = (~(_e2185) + select(0u, 1u, (_e2176 == 0u)));
} else {
phi_3287_ = _e2185;
}
let _e2198 = phi_3287_;
let _e2220 = ((((f32(bitcast<i32>(((_e2198 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2198 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2194 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2194 & 65535u)))));
let _e2226 = (_e2110 + 4i);
let _e2228 = select(_e1420, _e2226, (_e2226 < _e1420));
let _e2234 = global_5.member[bitcast<u32>(select(0i, _e2228, (_e2228 > 0i)))];
let _e2235 = (_e2110 + 5i);
let _e2237 = select(_e1420, _e2235, (_e2235 < _e1420));
let _e2243 = global_5.member[bitcast<u32>(select(0i, _e2237, (_e2237 > 0i)))];
let _e2246 = ((_e2243 >> bitcast<u32>(31i)) != 0u);
if _e2246 {
phi_3349_ = (~(_e2234) + 1u);
} else {
phi_3349_ = _e2234;
}
let _e2252 = phi_3349_;
if _e2246 {
phi_3355_ = (~(_e2243) + select(0u, 1u, (_e2234 == 0u)));
} else {
phi_3355_ = _e2243;
}
let _e2256 = phi_3355_;
let _e2278 = ((((f32(bitcast<i32>(((_e2256 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2256 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2252 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2252 & 65535u)))));
if _e1885 {
phi_3410_ = (_e1659 - 1i);
} else {
phi_3410_ = _e1884;
}
let _e2289 = phi_3410_;
if _e2092 {
phi_3422_ = (_e1666 - 1i);
} else {
phi_3422_ = _e2091;
}
let _e2292 = phi_3422_;
if _e1689 {
phi_3454_ = 0u;
} else {
if (_e1598 == 1u) {
phi_3453_ = _e1676;
} else {
if (_e1598 == 2u) {
phi_3452_ = _e1680;
} else {
phi_3452_ = select(_e1688, _e1684, (_e1598 == 3u));
}
let _e2298 = phi_3452_;
phi_3453_ = _e2298;
}
let _e2300 = phi_3453_;
phi_3454_ = _e2300;
}
let _e2302 = phi_3454_;
let _e2307 = (((bitcast<i32>(_e2302) + (_e2292 * _e1659)) + _e2289) * 6i);
let _e2309 = select(_e1420, _e2307, (_e2307 < _e1420));
let _e2315 = global_5.member[bitcast<u32>(select(0i, _e2309, (_e2309 > 0i)))];
let _e2316 = (_e2307 + 1i);
let _e2318 = select(_e1420, _e2316, (_e2316 < _e1420));
let _e2324 = global_5.member[bitcast<u32>(select(0i, _e2318, (_e2318 > 0i)))];
let _e2327 = ((_e2324 >> bitcast<u32>(31i)) != 0u);
if _e2327 {
phi_3513_ = (~(_e2315) + 1u);
} else {
phi_3513_ = _e2315;
}
let _e2333 = phi_3513_;
if _e2327 {
phi_3519_ = (~(_e2324) + select(0u, 1u, (_e2315 == 0u)));
} else {
phi_3519_ = _e2324;
}
let _e2337 = phi_3519_;
let _e2359 = ((((f32(bitcast<i32>(((_e2337 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2337 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2333 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2333 & 65535u)))));
let _e2365 = (_e2307 + 2i);
let _e2367 = select(_e1420, _e2365, (_e2365 < _e1420));
let _e2373 = global_5.member[bitcast<u32>(select(0i, _e2367, (_e2367 > 0i)))];
let _e2374 = (_e2307 + 3i);
let _e2376 = select(_e1420, _e2374, (_e2374 < _e1420));
let _e2382 = global_5.member[bitcast<u32>(select(0i, _e2376, (_e2376 > 0i)))];
let _e2385 = ((_e2382 >> bitcast<u32>(31i)) != 0u);
if _e2385 {
phi_3581_ = (~(_e2373) + 1u);
} else {
phi_3581_ = _e2373;
}
let _e2391 = phi_3581_;
if _e2385 {
phi_3587_ = (~(_e2382) + select(0u, 1u, (_e2373 == 0u)));
} else {
phi_3587_ = _e2382;
}
let _e2395 = phi_3587_;
let _e2417 = ((((f32(bitcast<i32>(((_e2395 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2395 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2391 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2391 & 65535u)))));
let _e2423 = (_e2307 + 4i);
let _e2425 = select(_e1420, _e2423, (_e2423 < _e1420));
let _e2431 = global_5.member[bitcast<u32>(select(0i, _e2425, (_e2425 > 0i)))];
let _e2432 = (_e2307 + 5i);
let _e2434 = select(_e1420, _e2432, (_e2432 < _e1420));
let _e2440 = global_5.member[bitcast<u32>(select(0i, _e2434, (_e2434 > 0i)))];
let _e2443 = ((_e2440 >> bitcast<u32>(31i)) != 0u);
if _e2443 {
phi_3649_ = (~(_e2431) + 1u);
} else {
phi_3649_ = _e2431;
}
let _e2449 = phi_3649_;
if _e2443 {
phi_3655_ = (~(_e2440) + select(0u, 1u, (_e2431 == 0u)));
} else {
phi_3655_ = _e2440;
}
let _e2453 = phi_3655_;
let _e2475 = ((((f32(bitcast<i32>(((_e2453 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2453 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2449 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2449 & 65535u)))));
let _e2487 = (1f - _e1648);
phi_2407_ = vec3<f32>((_e1596.x + ((((select(_e1756, -(bitcast<f32>((bitcast<u32>(_e1756) & 2147483647u))), _e1724) * _e1878) + (select(_e1958, -(bitcast<f32>((bitcast<u32>(_e1958) & 2147483647u))), _e1926) * _e1646)) * _e2487) + (((select(_e2162, -(bitcast<f32>((bitcast<u32>(_e2162) & 2147483647u))), _e2130) * _e1878) + (select(_e2359, -(bitcast<f32>((bitcast<u32>(_e2359) & 2147483647u))), _e2327) * _e1646)) * _e1648))), (_e1596.y + ((((select(_e1814, -(bitcast<f32>((bitcast<u32>(_e1814) & 2147483647u))), _e1782) * _e1878) + (select(_e2016, -(bitcast<f32>((bitcast<u32>(_e2016) & 2147483647u))), _e1984) * _e1646)) * _e2487) + (((select(_e2220, -(bitcast<f32>((bitcast<u32>(_e2220) & 2147483647u))), _e2188) * _e1878) + (select(_e2417, -(bitcast<f32>((bitcast<u32>(_e2417) & 2147483647u))), _e2385) * _e1646)) * _e1648))), (_e1596.z + ((((select(_e1872, -(bitcast<f32>((bitcast<u32>(_e1872) & 2147483647u))), _e1840) * _e1878) + (select(_e2074, -(bitcast<f32>((bitcast<u32>(_e2074) & 2147483647u))), _e2042) * _e1646)) * _e2487) + (((select(_e2278, -(bitcast<f32>((bitcast<u32>(_e2278) & 2147483647u))), _e2246) * _e1878) + (select(_e2475, -(bitcast<f32>((bitcast<u32>(_e2475) & 2147483647u))), _e2443) * _e1646)) * _e1648))));
phi_2410_ = (_e1598 + 1u);
} else {
phi_2407_ = vec3<f32>();
phi_2410_ = u32();
}
let _e2506 = phi_2407_;
let _e2508 = phi_2410_;
continue;
continuing {
phi_2406_ = _e2506;
phi_2409_ = _e2508;
break if !(_e1601);
}
}
let _e2511 = local_4;
let _e2515 = local_5;
let _e2519 = local_6;
let _e2522 = ((_e2511.x * _e1394) + _e203);
let _e2523 = ((_e2515.y * _e1394) + _e214);
let _e2524 = ((_e2519.z * _e1394) + _e225);
let _e2525 = (_e137 - _e2522);
let _e2526 = (_e148 - _e2523);
let _e2527 = (_e159 - _e2524);
let _e2545 = global_2.member.member_2.member;
let _e2546 = (((((f32(_e270) + 0.5f) / f32(_e280)) * 2f) - 1f) * _e2545);
let _e2554 = global_2.member.member_2.member_1;
let _e2555 = ((1f - (((f32(_e271) + 0.5f) / f32(_e287)) * 2f)) * _e2554);
let _e2558 = global_2.member.member_3;
let _e2567 = global_2.member.member_4;
let _e2580 = global_2.member.member_2.member_3;
let _e2581 = (_e2580 != 0u);
let _e2584 = global_2.member.member_5;
let _e2591 = select((_e2584.member + ((_e2558.member * _e2546) + (_e2567.member * _e2555))), _e2584.member, _e2581);
let _e2592 = select((_e2584.member_1 + ((_e2558.member_1 * _e2546) + (_e2567.member_1 * _e2555))), _e2584.member_1, _e2581);
let _e2593 = select((_e2584.member_2 + ((_e2558.member_2 * _e2546) + (_e2567.member_2 * _e2555))), _e2584.member_2, _e2581);
let _e2603 = (((_e2591 * _e2591) + (_e2592 * _e2592)) + (_e2593 * _e2593));
let _e2631 = select(0f, _e236, (_e236 > 0f));
let _e2639 = global_2.member.member_7;
global_1.member[_e71] = ((_e104 + select(0f, _e2525, (_e2525 > 0f))) + _e1407);
global_1.member[(_e69 + _e71)] = ((_e115 + select(0f, _e2526, (_e2526 > 0f))) + _e1408);
global_1.member[((2u * _e69) + _e71)] = ((_e126 + select(0f, _e2527, (_e2527 > 0f))) + _e1409);
global_1.member[((3u * _e69) + _e71)] = select(1f, _e2631, (_e2631 < 1f));
global_1.member[((4u * _e69) + _e71)] = _e104;
global_1.member[((5u * _e69) + _e71)] = _e115;
global_1.member[((6u * _e69) + _e71)] = _e126;
global_1.member[((7u * _e69) + _e71)] = _e137;
global_1.member[((8u * _e69) + _e71)] = _e148;
global_1.member[((9u * _e69) + _e71)] = _e159;
global_1.member[((10u * _e69) + _e71)] = _e1407;
global_1.member[((11u * _e69) + _e71)] = _e1408;
global_1.member[((12u * _e69) + _e71)] = _e1409;
global_1.member[((13u * _e69) + _e71)] = _e2522;
global_1.member[((14u * _e69) + _e71)] = _e2523;
global_1.member[((15u * _e69) + _e71)] = _e2524;
global_1.member[((16u * _e69) + _e71)] = select(0f, ((_e93 * ((((_e2584.member * _e2591) + (_e2584.member_1 * _e2592)) + (_e2584.member_2 * _e2593)) / sqrt(select(0f, _e2603, (_e2603 > 0f))))) * _e2639), (_e93 < (0.5f * 1e30f)));
global_1.member[((17u * _e69) + _e71)] = (((_e2558.member * _e247) + (_e2558.member_1 * _e258)) + (_e2558.member_2 * _e269));
global_1.member[((18u * _e69) + _e71)] = (((_e2567.member * _e247) + (_e2567.member_1 * _e258)) + (_e2567.member_2 * _e269));
global_1.member[((19u * _e69) + _e71)] = -((((_e2584.member * _e247) + (_e2584.member_1 * _e258)) + (_e2584.member_2 * _e269)));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
