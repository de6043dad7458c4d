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
struct type_12 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_13 {
member: u32,
member_1: u32,
}
struct type_15 {
member: array<f32>,
}
struct type_18 {
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
struct type_19 {
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
member_14: f32,
member_15: f32,
member_16: f32,
}
struct type_20 {
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
struct type_21 {
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
struct type_22 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_23 {
member: type_2,
member_1: type_13,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_18,
member_12: type_19,
member_13: type_20,
member_14: type_9,
member_15: type_6,
member_16: type_12,
member_17: u32,
member_18: type_21,
member_19: type_22,
}
struct type_24 {
member: type_23,
}
struct type_26 {
member: array<u32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(4)
var<storage, read_write> global_1: type_15;
@group(0) @binding(0)
var<storage> global_2: type_24;
@group(0) @binding(1)
var<storage> global_3: type_15;
@group(0) @binding(2)
var<storage> global_4: type_26;
@group(0) @binding(3)
var<storage> global_5: type_26;
fn function_() {
var phi_590_: i32;
var phi_602_: i32;
var phi_693_: u32;
var phi_699_: u32;
var phi_761_: u32;
var phi_767_: u32;
var phi_829_: u32;
var phi_835_: u32;
var phi_858_: vec3<f32>;
var phi_861_: u32;
var phi_962_: i32;
var phi_974_: i32;
var phi_1004_: u32;
var phi_1005_: u32;
var phi_1006_: u32;
var phi_1065_: u32;
var phi_1071_: u32;
var phi_1133_: u32;
var phi_1139_: u32;
var phi_1201_: u32;
var phi_1207_: u32;
var phi_1261_: i32;
var phi_1273_: i32;
var phi_1303_: u32;
var phi_1304_: u32;
var phi_1305_: u32;
var phi_1364_: u32;
var phi_1370_: u32;
var phi_1432_: u32;
var phi_1438_: u32;
var phi_1500_: u32;
var phi_1506_: u32;
var phi_1562_: i32;
var phi_1574_: i32;
var phi_1604_: u32;
var phi_1605_: u32;
var phi_1606_: u32;
var phi_1665_: u32;
var phi_1671_: u32;
var phi_1733_: u32;
var phi_1739_: u32;
var phi_1801_: u32;
var phi_1807_: u32;
var phi_1862_: i32;
var phi_1874_: i32;
var phi_1904_: u32;
var phi_1905_: u32;
var phi_1906_: u32;
var phi_1965_: u32;
var phi_1971_: u32;
var phi_2033_: u32;
var phi_2039_: u32;
var phi_2101_: u32;
var phi_2107_: u32;
var phi_859_: vec3<f32>;
var phi_862_: u32;
var local: vec3<f32>;
var local_1: vec3<f32>;
var local_2: vec3<f32>;
var phi_2197_: i32;
var phi_2209_: i32;
var phi_2300_: u32;
var phi_2306_: u32;
var phi_2368_: u32;
var phi_2374_: u32;
var phi_2436_: u32;
var phi_2442_: u32;
var phi_2465_: vec3<f32>;
var phi_2468_: u32;
var local_3: u32;
var phi_2569_: i32;
var phi_2581_: i32;
var phi_2611_: u32;
var phi_2612_: u32;
var phi_2613_: u32;
var phi_2672_: u32;
var phi_2678_: u32;
var phi_2740_: u32;
var phi_2746_: u32;
var phi_2808_: u32;
var phi_2814_: u32;
var phi_2868_: i32;
var phi_2880_: i32;
var phi_2910_: u32;
var phi_2911_: u32;
var phi_2912_: u32;
var phi_2971_: u32;
var phi_2977_: u32;
var phi_3039_: u32;
var phi_3045_: u32;
var phi_3107_: u32;
var phi_3113_: u32;
var phi_3169_: i32;
var phi_3181_: i32;
var phi_3211_: u32;
var phi_3212_: u32;
var phi_3213_: u32;
var phi_3272_: u32;
var phi_3278_: u32;
var phi_3340_: u32;
var phi_3346_: u32;
var phi_3408_: u32;
var phi_3414_: u32;
var phi_3469_: i32;
var phi_3481_: i32;
var phi_3511_: u32;
var phi_3512_: u32;
var phi_3513_: u32;
var phi_3572_: u32;
var phi_3578_: u32;
var phi_3640_: u32;
var phi_3646_: u32;
var phi_3708_: u32;
var phi_3714_: u32;
var phi_2466_: vec3<f32>;
var phi_2469_: u32;
var local_4: vec3<f32>;
var local_5: vec3<f32>;
var local_6: vec3<f32>;
let _e56 = global;
let _e65 = global_2.member.member;
if (_e56.x < _e65.member) {
if (_e56.y < _e65.member_1) {
let _e72 = (_e65.member * _e65.member_1);
let _e74 = ((_e56.y * _e65.member) + _e56.x);
let _e78 = global_2.member.member.member;
let _e82 = global_2.member.member.member_1;
let _e83 = (_e78 * _e82);
let _e85 = ((_e56.y * _e78) + _e56.x);
let _e86 = bitcast<i32>(_e85);
let _e88 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e90 = select(_e88, _e86, (_e86 < _e88));
let _e96 = global_3.member[bitcast<u32>(select(0i, _e90, (_e90 > 0i)))];
let _e99 = bitcast<i32>(((3u * _e83) + _e85));
let _e101 = select(_e88, _e99, (_e99 < _e88));
let _e107 = global_3.member[bitcast<u32>(select(0i, _e101, (_e101 > 0i)))];
let _e110 = bitcast<i32>(((4u * _e83) + _e85));
let _e112 = select(_e88, _e110, (_e110 < _e88));
let _e118 = global_3.member[bitcast<u32>(select(0i, _e112, (_e112 > 0i)))];
let _e121 = bitcast<i32>(((5u * _e83) + _e85));
let _e123 = select(_e88, _e121, (_e121 < _e88));
let _e129 = global_3.member[bitcast<u32>(select(0i, _e123, (_e123 > 0i)))];
let _e132 = bitcast<i32>(((6u * _e83) + _e85));
let _e134 = select(_e88, _e132, (_e132 < _e88));
let _e140 = global_3.member[bitcast<u32>(select(0i, _e134, (_e134 > 0i)))];
let _e143 = bitcast<i32>(((7u * _e83) + _e85));
let _e145 = select(_e88, _e143, (_e143 < _e88));
let _e151 = global_3.member[bitcast<u32>(select(0i, _e145, (_e145 > 0i)))];
let _e154 = bitcast<i32>(((8u * _e83) + _e85));
let _e156 = select(_e88, _e154, (_e154 < _e88));
let _e162 = global_3.member[bitcast<u32>(select(0i, _e156, (_e156 > 0i)))];
let _e165 = bitcast<i32>(((9u * _e83) + _e85));
let _e167 = select(_e88, _e165, (_e165 < _e88));
let _e173 = global_3.member[bitcast<u32>(select(0i, _e167, (_e167 > 0i)))];
let _e176 = bitcast<i32>(((10u * _e83) + _e85));
let _e178 = select(_e88, _e176, (_e176 < _e88));
let _e184 = global_3.member[bitcast<u32>(select(0i, _e178, (_e178 > 0i)))];
let _e187 = bitcast<i32>(((11u * _e83) + _e85));
let _e189 = select(_e88, _e187, (_e187 < _e88));
let _e195 = global_3.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e198 = bitcast<i32>(((12u * _e83) + _e85));
let _e200 = select(_e88, _e198, (_e198 < _e88));
let _e206 = global_3.member[bitcast<u32>(select(0i, _e200, (_e200 > 0i)))];
let _e209 = bitcast<i32>(((13u * _e83) + _e85));
let _e211 = select(_e88, _e209, (_e209 < _e88));
let _e217 = global_3.member[bitcast<u32>(select(0i, _e211, (_e211 > 0i)))];
let _e220 = bitcast<i32>(((14u * _e83) + _e85));
let _e222 = select(_e88, _e220, (_e220 < _e88));
let _e228 = global_3.member[bitcast<u32>(select(0i, _e222, (_e222 > 0i)))];
let _e231 = bitcast<i32>(((15u * _e83) + _e85));
let _e233 = select(_e88, _e231, (_e231 < _e88));
let _e239 = global_3.member[bitcast<u32>(select(0i, _e233, (_e233 > 0i)))];
let _e242 = bitcast<i32>(((16u * _e83) + _e85));
let _e244 = select(_e88, _e242, (_e242 < _e88));
let _e250 = global_3.member[bitcast<u32>(select(0i, _e244, (_e244 > 0i)))];
let _e253 = bitcast<i32>(((17u * _e83) + _e85));
let _e255 = select(_e88, _e253, (_e253 < _e88));
let _e261 = global_3.member[bitcast<u32>(select(0i, _e255, (_e255 > 0i)))];
let _e264 = bitcast<i32>(((18u * _e83) + _e85));
let _e266 = select(_e88, _e264, (_e264 < _e88));
let _e272 = global_3.member[bitcast<u32>(select(0i, _e266, (_e266 > 0i)))];
let _e275 = bitcast<i32>(((19u * _e83) + _e85));
let _e277 = select(_e88, _e275, (_e275 < _e88));
let _e283 = global_3.member[bitcast<u32>(select(0i, _e277, (_e277 > 0i)))];
let _e286 = bitcast<i32>(((20u * _e83) + _e85));
let _e288 = select(_e88, _e286, (_e286 < _e88));
let _e294 = global_3.member[bitcast<u32>(select(0i, _e288, (_e288 > 0i)))];
let _e297 = bitcast<i32>(((21u * _e83) + _e85));
let _e299 = select(_e88, _e297, (_e297 < _e88));
let _e305 = global_3.member[bitcast<u32>(select(0i, _e299, (_e299 > 0i)))];
let _e306 = bitcast<i32>(_e56.x);
let _e307 = bitcast<i32>(_e56.y);
let _e311 = global_2.member.member_1.member;
let _e315 = global_2.member.member_1.member_1;
let _e316 = bitcast<i32>(_e311);
let _e318 = select(_e306, 0i, (_e306 < 0i));
let _e319 = (_e318 >= _e316);
if _e319 {
phi_590_ = (_e316 - 1i);
} else {
phi_590_ = _e318;
}
let _e322 = phi_590_;
let _e323 = bitcast<i32>(_e315);
let _e325 = select(_e307, 0i, (_e307 < 0i));
let _e326 = (_e325 >= _e323);
if _e326 {
phi_602_ = (_e323 - 1i);
} else {
phi_602_ = _e325;
}
let _e329 = phi_602_;
let _e332 = (((_e329 * _e316) + _e322) * 6i);
let _e334 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e336 = select(_e334, _e332, (_e332 < _e334));
let _e342 = global_4.member[bitcast<u32>(select(0i, _e336, (_e336 > 0i)))];
let _e343 = (_e332 + 1i);
let _e345 = select(_e334, _e343, (_e343 < _e334));
let _e351 = global_4.member[bitcast<u32>(select(0i, _e345, (_e345 > 0i)))];
let _e354 = ((_e351 >> bitcast<u32>(31i)) != 0u);
if _e354 {
phi_693_ = (~(_e342) + 1u);
} else {
phi_693_ = _e342;
}
let _e360 = phi_693_;
if _e354 {
phi_699_ = (~(_e351) + select(0u, 1u, (_e342 == 0u)));
} else {
phi_699_ = _e351;
}
let _e364 = phi_699_;
let _e386 = ((((f32(bitcast<i32>(((_e364 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e364 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e360 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e360 & 65535u)))));
let _e392 = (_e332 + 2i);
let _e394 = select(_e334, _e392, (_e392 < _e334));
let _e400 = global_4.member[bitcast<u32>(select(0i, _e394, (_e394 > 0i)))];
let _e401 = (_e332 + 3i);
let _e403 = select(_e334, _e401, (_e401 < _e334));
let _e409 = global_4.member[bitcast<u32>(select(0i, _e403, (_e403 > 0i)))];
let _e412 = ((_e409 >> bitcast<u32>(31i)) != 0u);
if _e412 {
phi_761_ = (~(_e400) + 1u);
} else {
phi_761_ = _e400;
}
let _e418 = phi_761_;
if _e412 {
phi_767_ = (~(_e409) + select(0u, 1u, (_e400 == 0u)));
} else {
phi_767_ = _e409;
}
let _e422 = phi_767_;
let _e444 = ((((f32(bitcast<i32>(((_e422 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e422 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e418 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e418 & 65535u)))));
let _e450 = (_e332 + 4i);
let _e452 = select(_e334, _e450, (_e450 < _e334));
let _e458 = global_4.member[bitcast<u32>(select(0i, _e452, (_e452 > 0i)))];
let _e459 = (_e332 + 5i);
let _e461 = select(_e334, _e459, (_e459 < _e334));
let _e467 = global_4.member[bitcast<u32>(select(0i, _e461, (_e461 > 0i)))];
let _e470 = ((_e467 >> bitcast<u32>(31i)) != 0u);
if _e470 {
phi_829_ = (~(_e458) + 1u);
} else {
phi_829_ = _e458;
}
let _e476 = phi_829_;
if _e470 {
phi_835_ = (~(_e467) + select(0u, 1u, (_e458 == 0u)));
} else {
phi_835_ = _e467;
}
let _e480 = phi_835_;
let _e502 = ((((f32(bitcast<i32>(((_e480 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e480 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e476 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e476 & 65535u)))));
phi_858_ = vec3<f32>(select(_e386, -(bitcast<f32>((bitcast<u32>(_e386) & 2147483647u))), _e354), select(_e444, -(bitcast<f32>((bitcast<u32>(_e444) & 2147483647u))), _e412), select(_e502, -(bitcast<f32>((bitcast<u32>(_e502) & 2147483647u))), _e470));
phi_861_ = 1u;
loop {
let _e510 = phi_858_;
let _e512 = phi_861_;
local = _e510;
local_1 = _e510;
local_2 = _e510;
let _e516 = global_2.member.member_18.member_1;
let _e517 = (_e512 <= _e516);
local_3 = _e516;
if _e517 {
let _e518 = (_e512 & 31u);
let _e522 = (1f / f32((1i << bitcast<u32>(_e518))));
let _e526 = (((f32(_e306) + 0.5f) * _e522) - 0.5f);
let _e530 = (((f32(_e307) + 0.5f) * _e522) - 0.5f);
let _e532 = select(-1f, _e526, (_e526 > -1f));
let _e534 = select(1e6f, _e532, (_e532 < 1e6f));
let _e541 = select(0i, select(select(i32(_e534), i32(-2147483648), (_e534 < -2147483600f)), 2147483647i, (_e534 > 2147483500f)), (_e534 == _e534));
let _e545 = (_e541 - select(0i, 1i, (_e534 < f32(_e541))));
let _e547 = select(-1f, _e530, (_e530 > -1f));
let _e549 = select(1e6f, _e547, (_e547 < 1e6f));
let _e556 = select(0i, select(select(i32(_e549), i32(-2147483648), (_e549 < -2147483600f)), 2147483647i, (_e549 > 2147483500f)), (_e549 == _e549));
let _e560 = (_e556 - select(0i, 1i, (_e549 < f32(_e556))));
let _e562 = (_e526 - f32(_e545));
let _e564 = (_e530 - f32(_e560));
let _e566 = (1u << bitcast<u32>(_e518));
let _e575 = bitcast<i32>((((_e311 + _e566) - 1u) >> bitcast<u32>(_e518)));
let _e577 = select(_e545, 0i, (_e545 < 0i));
let _e578 = (_e577 >= _e575);
if _e578 {
phi_962_ = (_e575 - 1i);
} else {
phi_962_ = _e577;
}
let _e581 = phi_962_;
let _e582 = bitcast<i32>((((_e315 + _e566) - 1u) >> bitcast<u32>(_e518)));
let _e584 = select(_e560, 0i, (_e560 < 0i));
let _e585 = (_e584 >= _e582);
if _e585 {
phi_974_ = (_e582 - 1i);
} else {
phi_974_ = _e584;
}
let _e588 = phi_974_;
let _e592 = global_2.member.member_18.member_2;
let _e596 = global_2.member.member_18.member_3;
let _e600 = global_2.member.member_18.member_4;
let _e604 = global_2.member.member_18.member_5;
let _e605 = (_e512 == 0u);
if _e605 {
phi_1006_ = 0u;
} else {
if (_e512 == 1u) {
phi_1005_ = _e592;
} else {
if (_e512 == 2u) {
phi_1004_ = _e596;
} else {
phi_1004_ = select(_e604, _e600, (_e512 == 3u));
}
let _e611 = phi_1004_;
phi_1005_ = _e611;
}
let _e613 = phi_1005_;
phi_1006_ = _e613;
}
let _e615 = phi_1006_;
let _e620 = (((bitcast<i32>(_e615) + (_e588 * _e575)) + _e581) * 6i);
let _e622 = select(_e334, _e620, (_e620 < _e334));
let _e628 = global_4.member[bitcast<u32>(select(0i, _e622, (_e622 > 0i)))];
let _e629 = (_e620 + 1i);
let _e631 = select(_e334, _e629, (_e629 < _e334));
let _e637 = global_4.member[bitcast<u32>(select(0i, _e631, (_e631 > 0i)))];
let _e640 = ((_e637 >> bitcast<u32>(31i)) != 0u);
if _e640 {
phi_1065_ = (~(_e628) + 1u);
} else {
phi_1065_ = _e628;
}
let _e646 = phi_1065_;
if _e640 {
phi_1071_ = (~(_e637) + select(0u, 1u, (_e628 == 0u)));
} else {
phi_1071_ = _e637;
}
let _e650 = phi_1071_;
let _e672 = ((((f32(bitcast<i32>(((_e650 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e650 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e646 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e646 & 65535u)))));
let _e678 = (_e620 + 2i);
let _e680 = select(_e334, _e678, (_e678 < _e334));
let _e686 = global_4.member[bitcast<u32>(select(0i, _e680, (_e680 > 0i)))];
let _e687 = (_e620 + 3i);
let _e689 = select(_e334, _e687, (_e687 < _e334));
let _e695 = global_4.member[bitcast<u32>(select(0i, _e689, (_e689 > 0i)))];
let _e698 = ((_e695 >> bitcast<u32>(31i)) != 0u);
if _e698 {
phi_1133_ = (~(_e686) + 1u);
} else {
phi_1133_ = _e686;
}
let _e704 = phi_1133_;
if _e698 {
phi_1139_ = (~(_e695) + select(0u, 1u, (_e686 == 0u)));
} else {
phi_1139_ = _e695;
}
let _e708 = phi_1139_;
let _e730 = ((((f32(bitcast<i32>(((_e708 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e708 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e704 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e704 & 65535u)))));
let _e736 = (_e620 + 4i);
let _e738 = select(_e334, _e736, (_e736 < _e334));
let _e744 = global_4.member[bitcast<u32>(select(0i, _e738, (_e738 > 0i)))];
let _e745 = (_e620 + 5i);
let _e747 = select(_e334, _e745, (_e745 < _e334));
let _e753 = global_4.member[bitcast<u32>(select(0i, _e747, (_e747 > 0i)))];
let _e756 = ((_e753 >> bitcast<u32>(31i)) != 0u);
if _e756 {
phi_1201_ = (~(_e744) + 1u);
} else {
phi_1201_ = _e744;
}
let _e762 = phi_1201_;
if _e756 {
phi_1207_ = (~(_e753) + select(0u, 1u, (_e744 == 0u)));
} else {
phi_1207_ = _e753;
}
let _e766 = phi_1207_;
let _e788 = ((((f32(bitcast<i32>(((_e766 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e766 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e762 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e762 & 65535u)))));
let _e794 = (1f - _e562);
let _e798 = (_e545 + 1i);
let _e800 = select(_e798, 0i, (_e798 < 0i));
let _e801 = (_e800 >= _e575);
if _e801 {
phi_1261_ = (_e575 - 1i);
} else {
phi_1261_ = _e800;
}
let _e804 = phi_1261_;
if _e585 {
phi_1273_ = (_e582 - 1i);
} else {
phi_1273_ = _e584;
}
let _e807 = phi_1273_;
if _e605 {
phi_1305_ = 0u;
} else {
if (_e512 == 1u) {
phi_1304_ = _e592;
} else {
if (_e512 == 2u) {
phi_1303_ = _e596;
} else {
phi_1303_ = select(_e604, _e600, (_e512 == 3u));
}
let _e813 = phi_1303_;
phi_1304_ = _e813;
}
let _e815 = phi_1304_;
phi_1305_ = _e815;
}
let _e817 = phi_1305_;
let _e822 = (((bitcast<i32>(_e817) + (_e807 * _e575)) + _e804) * 6i);
let _e824 = select(_e334, _e822, (_e822 < _e334));
let _e830 = global_4.member[bitcast<u32>(select(0i, _e824, (_e824 > 0i)))];
let _e831 = (_e822 + 1i);
let _e833 = select(_e334, _e831, (_e831 < _e334));
let _e839 = global_4.member[bitcast<u32>(select(0i, _e833, (_e833 > 0i)))];
let _e842 = ((_e839 >> bitcast<u32>(31i)) != 0u);
if _e842 {
phi_1364_ = (~(_e830) + 1u);
} else {
phi_1364_ = _e830;
}
let _e848 = phi_1364_;
if _e842 {
phi_1370_ = (~(_e839) + select(0u, 1u, (_e830 == 0u)));
} else {
phi_1370_ = _e839;
}
let _e852 = phi_1370_;
let _e874 = ((((f32(bitcast<i32>(((_e852 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e852 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e848 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e848 & 65535u)))));
let _e880 = (_e822 + 2i);
let _e882 = select(_e334, _e880, (_e880 < _e334));
let _e888 = global_4.member[bitcast<u32>(select(0i, _e882, (_e882 > 0i)))];
let _e889 = (_e822 + 3i);
let _e891 = select(_e334, _e889, (_e889 < _e334));
let _e897 = global_4.member[bitcast<u32>(select(0i, _e891, (_e891 > 0i)))];
let _e900 = ((_e897 >> bitcast<u32>(31i)) != 0u);
if _e900 {
phi_1432_ = (~(_e888) + 1u);
} else {
phi_1432_ = _e888;
}
let _e906 = phi_1432_;
if _e900 {
phi_1438_ = (~(_e897) + select(0u, 1u, (_e888 == 0u)));
} else {
phi_1438_ = _e897;
}
let _e910 = phi_1438_;
let _e932 = ((((f32(bitcast<i32>(((_e910 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e910 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e906 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e906 & 65535u)))));
let _e938 = (_e822 + 4i);
let _e940 = select(_e334, _e938, (_e938 < _e334));
let _e946 = global_4.member[bitcast<u32>(select(0i, _e940, (_e940 > 0i)))];
let _e947 = (_e822 + 5i);
let _e949 = select(_e334, _e947, (_e947 < _e334));
let _e955 = global_4.member[bitcast<u32>(select(0i, _e949, (_e949 > 0i)))];
let _e958 = ((_e955 >> bitcast<u32>(31i)) != 0u);
if _e958 {
phi_1500_ = (~(_e946) + 1u);
} else {
phi_1500_ = _e946;
}
let _e964 = phi_1500_;
if _e958 {
phi_1506_ = (~(_e955) + select(0u, 1u, (_e946 == 0u)));
} else {
phi_1506_ = _e955;
}
let _e968 = phi_1506_;
let _e990 = ((((f32(bitcast<i32>(((_e968 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e968 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e964 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e964 & 65535u)))));
let _e1002 = (_e560 + 1i);
if _e578 {
phi_1562_ = (_e575 - 1i);
} else {
phi_1562_ = _e577;
}
let _e1005 = phi_1562_;
let _e1007 = select(_e1002, 0i, (_e1002 < 0i));
let _e1008 = (_e1007 >= _e582);
if _e1008 {
phi_1574_ = (_e582 - 1i);
} else {
phi_1574_ = _e1007;
}
let _e1011 = phi_1574_;
if _e605 {
phi_1606_ = 0u;
} else {
if (_e512 == 1u) {
phi_1605_ = _e592;
} else {
if (_e512 == 2u) {
phi_1604_ = _e596;
} else {
phi_1604_ = select(_e604, _e600, (_e512 == 3u));
}
let _e1017 = phi_1604_;
phi_1605_ = _e1017;
}
let _e1019 = phi_1605_;
phi_1606_ = _e1019;
}
let _e1021 = phi_1606_;
let _e1026 = (((bitcast<i32>(_e1021) + (_e1011 * _e575)) + _e1005) * 6i);
let _e1028 = select(_e334, _e1026, (_e1026 < _e334));
let _e1034 = global_4.member[bitcast<u32>(select(0i, _e1028, (_e1028 > 0i)))];
let _e1035 = (_e1026 + 1i);
let _e1037 = select(_e334, _e1035, (_e1035 < _e334));
let _e1043 = global_4.member[bitcast<u32>(select(0i, _e1037, (_e1037 > 0i)))];
let _e1046 = ((_e1043 >> bitcast<u32>(31i)) != 0u);
if _e1046 {
phi_1665_ = (~(_e1034) + 1u);
} else {
phi_1665_ = _e1034;
}
let _e1052 = phi_1665_;
if _e1046 {
phi_1671_ = (~(_e1043) + select(0u, 1u, (_e1034 == 0u)));
} else {
phi_1671_ = _e1043;
}
let _e1056 = phi_1671_;
let _e1078 = ((((f32(bitcast<i32>(((_e1056 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1056 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1052 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1052 & 65535u)))));
let _e1084 = (_e1026 + 2i);
let _e1086 = select(_e334, _e1084, (_e1084 < _e334));
let _e1092 = global_4.member[bitcast<u32>(select(0i, _e1086, (_e1086 > 0i)))];
let _e1093 = (_e1026 + 3i);
let _e1095 = select(_e334, _e1093, (_e1093 < _e334));
let _e1101 = global_4.member[bitcast<u32>(select(0i, _e1095, (_e1095 > 0i)))];
let _e1104 = ((_e1101 >> bitcast<u32>(31i)) != 0u);
if _e1104 {
phi_1733_ = (~(_e1092) + 1u);
} else {
phi_1733_ = _e1092;
}
let _e1110 = phi_1733_;
if _e1104 {
phi_1739_ = (~(_e1101) + select(0u, 1u, (_e1092 == 0u)));
} else {
phi_1739_ = _e1101;
}
let _e1114 = phi_1739_;
let _e1136 = ((((f32(bitcast<i32>(((_e1114 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1114 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1110 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1110 & 65535u)))));
let _e1142 = (_e1026 + 4i);
let _e1144 = select(_e334, _e1142, (_e1142 < _e334));
let _e1150 = global_4.member[bitcast<u32>(select(0i, _e1144, (_e1144 > 0i)))];
let _e1151 = (_e1026 + 5i);
let _e1153 = select(_e334, _e1151, (_e1151 < _e334));
let _e1159 = global_4.member[bitcast<u32>(select(0i, _e1153, (_e1153 > 0i)))];
let _e1162 = ((_e1159 >> bitcast<u32>(31i)) != 0u);
if _e1162 {
phi_1801_ = (~(_e1150) + 1u);
} else {
phi_1801_ = _e1150;
}
let _e1168 = phi_1801_;
if _e1162 {
phi_1807_ = (~(_e1159) + select(0u, 1u, (_e1150 == 0u)));
} else {
phi_1807_ = _e1159;
}
let _e1172 = phi_1807_;
let _e1194 = ((((f32(bitcast<i32>(((_e1172 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1172 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1168 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1168 & 65535u)))));
if _e801 {
phi_1862_ = (_e575 - 1i);
} else {
phi_1862_ = _e800;
}
let _e1205 = phi_1862_;
if _e1008 {
phi_1874_ = (_e582 - 1i);
} else {
phi_1874_ = _e1007;
}
let _e1208 = phi_1874_;
if _e605 {
phi_1906_ = 0u;
} else {
if (_e512 == 1u) {
phi_1905_ = _e592;
} else {
if (_e512 == 2u) {
phi_1904_ = _e596;
} else {
phi_1904_ = select(_e604, _e600, (_e512 == 3u));
}
let _e1214 = phi_1904_;
phi_1905_ = _e1214;
}
let _e1216 = phi_1905_;
phi_1906_ = _e1216;
}
let _e1218 = phi_1906_;
let _e1223 = (((bitcast<i32>(_e1218) + (_e1208 * _e575)) + _e1205) * 6i);
let _e1225 = select(_e334, _e1223, (_e1223 < _e334));
let _e1231 = global_4.member[bitcast<u32>(select(0i, _e1225, (_e1225 > 0i)))];
let _e1232 = (_e1223 + 1i);
let _e1234 = select(_e334, _e1232, (_e1232 < _e334));
let _e1240 = global_4.member[bitcast<u32>(select(0i, _e1234, (_e1234 > 0i)))];
let _e1243 = ((_e1240 >> bitcast<u32>(31i)) != 0u);
if _e1243 {
phi_1965_ = (~(_e1231) + 1u);
} else {
phi_1965_ = _e1231;
}
let _e1249 = phi_1965_;
if _e1243 {
phi_1971_ = (~(_e1240) + select(0u, 1u, (_e1231 == 0u)));
} else {
phi_1971_ = _e1240;
}
let _e1253 = phi_1971_;
let _e1275 = ((((f32(bitcast<i32>(((_e1253 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1253 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1249 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1249 & 65535u)))));
let _e1281 = (_e1223 + 2i);
let _e1283 = select(_e334, _e1281, (_e1281 < _e334));
let _e1289 = global_4.member[bitcast<u32>(select(0i, _e1283, (_e1283 > 0i)))];
let _e1290 = (_e1223 + 3i);
let _e1292 = select(_e334, _e1290, (_e1290 < _e334));
let _e1298 = global_4.member[bitcast<u32>(select(0i, _e1292, (_e1292 > 0i)))];
let _e1301 = ((_e1298 >> bitcast<u32>(31i)) != 0u);
if _e1301 {
phi_2033_ = (~(_e1289) + 1u);
} else {
phi_2033_ = _e1289;
}
let _e1307 = phi_2033_;
if _e1301 {
phi_2039_ = (~(_e1298) + select(0u, 1u, (_e1289 == 0u)));
} else {
phi_2039_ = _e1298;
}
let _e1311 = phi_2039_;
let _e1333 = ((((f32(bitcast<i32>(((_e1311 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1311 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1307 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1307 & 65535u)))));
let _e1339 = (_e1223 + 4i);
let _e1341 = select(_e334, _e1339, (_e1339 < _e334));
let _e1347 = global_4.member[bitcast<u32>(select(0i, _e1341, (_e1341 > 0i)))];
let _e1348 = (_e1223 + 5i);
let _e1350 = select(_e334, _e1348, (_e1348 < _e334));
let _e1356 = global_4.member[bitcast<u32>(select(0i, _e1350, (_e1350 > 0i)))];
let _e1359 = ((_e1356 >> bitcast<u32>(31i)) != 0u);
if _e1359 {
phi_2101_ = (~(_e1347) + 1u);
} else {
phi_2101_ = _e1347;
}
let _e1365 = phi_2101_;
if _e1359 {
phi_2107_ = (~(_e1356) + select(0u, 1u, (_e1347 == 0u)));
} else {
phi_2107_ = _e1356;
}
let _e1369 = phi_2107_;
let _e1391 = ((((f32(bitcast<i32>(((_e1369 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1369 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1365 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1365 & 65535u)))));
let _e1403 = (1f - _e564);
phi_859_ = vec3<f32>((_e510.x + ((((select(_e672, -(bitcast<f32>((bitcast<u32>(_e672) & 2147483647u))), _e640) * _e794) + (select(_e874, -(bitcast<f32>((bitcast<u32>(_e874) & 2147483647u))), _e842) * _e562)) * _e1403) + (((select(_e1078, -(bitcast<f32>((bitcast<u32>(_e1078) & 2147483647u))), _e1046) * _e794) + (select(_e1275, -(bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u))), _e1243) * _e562)) * _e564))), (_e510.y + ((((select(_e730, -(bitcast<f32>((bitcast<u32>(_e730) & 2147483647u))), _e698) * _e794) + (select(_e932, -(bitcast<f32>((bitcast<u32>(_e932) & 2147483647u))), _e900) * _e562)) * _e1403) + (((select(_e1136, -(bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u))), _e1104) * _e794) + (select(_e1333, -(bitcast<f32>((bitcast<u32>(_e1333) & 2147483647u))), _e1301) * _e562)) * _e564))), (_e510.z + ((((select(_e788, -(bitcast<f32>((bitcast<u32>(_e788) & 2147483647u))), _e756) * _e794) + (select(_e990, -(bitcast<f32>((bitcast<u32>(_e990) & 2147483647u))), _e958) * _e562)) * _e1403) + (((select(_e1194, -(bitcast<f32>((bitcast<u32>(_e1194) & 2147483647u))), _e1162) * _e794) + (select(_e1391, -(bitcast<f32>((bitcast<u32>(_e1391) & 2147483647u))), _e1359) * _e562)) * _e564))));
phi_862_ = (_e512 + 1u);
} else {
phi_859_ = vec3<f32>();
phi_862_ = u32();
}
let _e1422 = phi_859_;
let _e1424 = phi_862_;
continue;
continuing {
phi_858_ = _e1422;
phi_861_ = _e1424;
break if !(_e517);
}
}
let _e1429 = global_2.member.member_18.member;
let _e1430 = (1f / _e1429);
let _e1432 = local;
let _e1436 = local_1;
let _e1440 = local_2;
let _e1443 = ((_e1432.x * _e1430) + _e173);
let _e1444 = ((_e1436.y * _e1430) + _e184);
let _e1445 = ((_e1440.z * _e1430) + _e195);
if _e319 {
phi_2197_ = (_e316 - 1i);
} else {
phi_2197_ = _e318;
}
let _e1448 = phi_2197_;
if _e326 {
phi_2209_ = (_e323 - 1i);
} else {
phi_2209_ = _e325;
}
let _e1451 = phi_2209_;
let _e1454 = (((_e1451 * _e316) + _e1448) * 6i);
let _e1456 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1458 = select(_e1456, _e1454, (_e1454 < _e1456));
let _e1464 = global_5.member[bitcast<u32>(select(0i, _e1458, (_e1458 > 0i)))];
let _e1465 = (_e1454 + 1i);
let _e1467 = select(_e1456, _e1465, (_e1465 < _e1456));
let _e1473 = global_5.member[bitcast<u32>(select(0i, _e1467, (_e1467 > 0i)))];
let _e1476 = ((_e1473 >> bitcast<u32>(31i)) != 0u);
if _e1476 {
phi_2300_ = (~(_e1464) + 1u);
} else {
phi_2300_ = _e1464;
}
let _e1482 = phi_2300_;
if _e1476 {
phi_2306_ = (~(_e1473) + select(0u, 1u, (_e1464 == 0u)));
} else {
phi_2306_ = _e1473;
}
let _e1486 = phi_2306_;
let _e1508 = ((((f32(bitcast<i32>(((_e1486 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1486 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1482 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1482 & 65535u)))));
let _e1514 = (_e1454 + 2i);
let _e1516 = select(_e1456, _e1514, (_e1514 < _e1456));
let _e1522 = global_5.member[bitcast<u32>(select(0i, _e1516, (_e1516 > 0i)))];
let _e1523 = (_e1454 + 3i);
let _e1525 = select(_e1456, _e1523, (_e1523 < _e1456));
let _e1531 = global_5.member[bitcast<u32>(select(0i, _e1525, (_e1525 > 0i)))];
let _e1534 = ((_e1531 >> bitcast<u32>(31i)) != 0u);
if _e1534 {
phi_2368_ = (~(_e1522) + 1u);
} else {
phi_2368_ = _e1522;
}
let _e1540 = phi_2368_;
if _e1534 {
phi_2374_ = (~(_e1531) + select(0u, 1u, (_e1522 == 0u)));
} else {
phi_2374_ = _e1531;
}
let _e1544 = phi_2374_;
let _e1566 = ((((f32(bitcast<i32>(((_e1544 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1544 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1540 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1540 & 65535u)))));
let _e1572 = (_e1454 + 4i);
let _e1574 = select(_e1456, _e1572, (_e1572 < _e1456));
let _e1580 = global_5.member[bitcast<u32>(select(0i, _e1574, (_e1574 > 0i)))];
let _e1581 = (_e1454 + 5i);
let _e1583 = select(_e1456, _e1581, (_e1581 < _e1456));
let _e1589 = global_5.member[bitcast<u32>(select(0i, _e1583, (_e1583 > 0i)))];
let _e1592 = ((_e1589 >> bitcast<u32>(31i)) != 0u);
if _e1592 {
phi_2436_ = (~(_e1580) + 1u);
} else {
phi_2436_ = _e1580;
}
let _e1598 = phi_2436_;
if _e1592 {
phi_2442_ = (~(_e1589) + select(0u, 1u, (_e1580 == 0u)));
} else {
phi_2442_ = _e1589;
}
let _e1602 = phi_2442_;
let _e1624 = ((((f32(bitcast<i32>(((_e1602 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1602 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1598 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1598 & 65535u)))));
phi_2465_ = vec3<f32>(select(_e1508, -(bitcast<f32>((bitcast<u32>(_e1508) & 2147483647u))), _e1476), select(_e1566, -(bitcast<f32>((bitcast<u32>(_e1566) & 2147483647u))), _e1534), select(_e1624, -(bitcast<f32>((bitcast<u32>(_e1624) & 2147483647u))), _e1592));
phi_2468_ = 1u;
loop {
let _e1632 = phi_2465_;
let _e1634 = phi_2468_;
local_4 = _e1632;
local_5 = _e1632;
local_6 = _e1632;
let _e1636 = local_3;
let _e1637 = (_e1634 <= _e1636);
if _e1637 {
let _e1638 = (_e1634 & 31u);
let _e1642 = (1f / f32((1i << bitcast<u32>(_e1638))));
let _e1646 = (((f32(_e306) + 0.5f) * _e1642) - 0.5f);
let _e1650 = (((f32(_e307) + 0.5f) * _e1642) - 0.5f);
let _e1652 = select(-1f, _e1646, (_e1646 > -1f));
let _e1654 = select(1e6f, _e1652, (_e1652 < 1e6f));
let _e1661 = select(0i, select(select(i32(_e1654), i32(-2147483648), (_e1654 < -2147483600f)), 2147483647i, (_e1654 > 2147483500f)), (_e1654 == _e1654));
let _e1665 = (_e1661 - select(0i, 1i, (_e1654 < f32(_e1661))));
let _e1667 = select(-1f, _e1650, (_e1650 > -1f));
let _e1669 = select(1e6f, _e1667, (_e1667 < 1e6f));
let _e1676 = select(0i, select(select(i32(_e1669), i32(-2147483648), (_e1669 < -2147483600f)), 2147483647i, (_e1669 > 2147483500f)), (_e1669 == _e1669));
let _e1680 = (_e1676 - select(0i, 1i, (_e1669 < f32(_e1676))));
let _e1682 = (_e1646 - f32(_e1665));
let _e1684 = (_e1650 - f32(_e1680));
let _e1686 = (1u << bitcast<u32>(_e1638));
let _e1695 = bitcast<i32>((((_e311 + _e1686) - 1u) >> bitcast<u32>(_e1638)));
let _e1697 = select(_e1665, 0i, (_e1665 < 0i));
let _e1698 = (_e1697 >= _e1695);
if _e1698 {
phi_2569_ = (_e1695 - 1i);
} else {
phi_2569_ = _e1697;
}
let _e1701 = phi_2569_;
let _e1702 = bitcast<i32>((((_e315 + _e1686) - 1u) >> bitcast<u32>(_e1638)));
let _e1704 = select(_e1680, 0i, (_e1680 < 0i));
let _e1705 = (_e1704 >= _e1702);
if _e1705 {
phi_2581_ = (_e1702 - 1i);
} else {
phi_2581_ = _e1704;
}
let _e1708 = phi_2581_;
let _e1712 = global_2.member.member_18.member_2;
let _e1716 = global_2.member.member_18.member_3;
let _e1720 = global_2.member.member_18.member_4;
let _e1724 = global_2.member.member_18.member_5;
let _e1725 = (_e1634 == 0u);
if _e1725 {
phi_2613_ = 0u;
} else {
if (_e1634 == 1u) {
phi_2612_ = _e1712;
} else {
if (_e1634 == 2u) {
phi_2611_ = _e1716;
} else {
phi_2611_ = select(_e1724, _e1720, (_e1634 == 3u));
}
let _e1731 = phi_2611_;
phi_2612_ = _e1731;
}
let _e1733 = phi_2612_;
phi_2613_ = _e1733;
}
let _e1735 = phi_2613_;
let _e1740 = (((bitcast<i32>(_e1735) + (_e1708 * _e1695)) + _e1701) * 6i);
let _e1742 = select(_e1456, _e1740, (_e1740 < _e1456));
let _e1748 = global_5.member[bitcast<u32>(select(0i, _e1742, (_e1742 > 0i)))];
let _e1749 = (_e1740 + 1i);
let _e1751 = select(_e1456, _e1749, (_e1749 < _e1456));
let _e1757 = global_5.member[bitcast<u32>(select(0i, _e1751, (_e1751 > 0i)))];
let _e1760 = ((_e1757 >> bitcast<u32>(31i)) != 0u);
if _e1760 {
phi_2672_ = (~(_e1748) + 1u);
} else {
phi_2672_ = _e1748;
}
let _e1766 = phi_2672_;
if _e1760 {
phi_2678_ = (~(_e1757) + select(0u, 1u, (_e1748 == 0u)));
} else {
phi_2678_ = _e1757;
}
let _e1770 = phi_2678_;
let _e1792 = ((((f32(bitcast<i32>(((_e1770 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1770 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1766 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1766 & 65535u)))));
let _e1798 = (_e1740 + 2i);
let _e1800 = select(_e1456, _e1798, (_e1798 < _e1456));
let _e1806 = global_5.member[bitcast<u32>(select(0i, _e1800, (_e1800 > 0i)))];
let _e1807 = (_e1740 + 3i);
let _e1809 = select(_e1456, _e1807, (_e1807 < _e1456));
let _e1815 = global_5.member[bitcast<u32>(select(0i, _e1809, (_e1809 > 0i)))];
let _e1818 = ((_e1815 >> bitcast<u32>(31i)) != 0u);
if _e1818 {
phi_2740_ = (~(_e1806) + 1u);
} else {
phi_2740_ = _e1806;
}
let _e1824 = phi_2740_;
if _e1818 {
phi_2746_ = (~(_e1815) + select(0u, 1u, (_e1806 == 0u)));
} else {
phi_2746_ = _e1815;
}
let _e1828 = phi_2746_;
let _e1850 = ((((f32(bitcast<i32>(((_e1828 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1828 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1824 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1824 & 65535u)))));
let _e1856 = (_e1740 + 4i);
let _e1858 = select(_e1456, _e1856, (_e1856 < _e1456));
let _e1864 = global_5.member[bitcast<u32>(select(0i, _e1858, (_e1858 > 0i)))];
let _e1865 = (_e1740 + 5i);
let _e1867 = select(_e1456, _e1865, (_e1865 < _e1456));
let _e1873 = global_5.member[bitcast<u32>(select(0i, _e1867, (_e1867 > 0i)))];
let _e1876 = ((_e1873 >> bitcast<u32>(31i)) != 0u);
if _e1876 {
phi_2808_ = (~(_e1864) + 1u);
} else {
phi_2808_ = _e1864;
}
let _e1882 = phi_2808_;
if _e1876 {
phi_2814_ = (~(_e1873) + select(0u, 1u, (_e1864 == 0u)));
} else {
phi_2814_ = _e1873;
}
let _e1886 = phi_2814_;
let _e1908 = ((((f32(bitcast<i32>(((_e1886 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1886 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1882 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1882 & 65535u)))));
let _e1914 = (1f - _e1682);
let _e1918 = (_e1665 + 1i);
let _e1920 = select(_e1918, 0i, (_e1918 < 0i));
let _e1921 = (_e1920 >= _e1695);
if _e1921 {
phi_2868_ = (_e1695 - 1i);
} else {
phi_2868_ = _e1920;
}
let _e1924 = phi_2868_;
if _e1705 {
phi_2880_ = (_e1702 - 1i);
} else {
phi_2880_ = _e1704;
}
let _e1927 = phi_2880_;
if _e1725 {
phi_2912_ = 0u;
} else {
if (_e1634 == 1u) {
phi_2911_ = _e1712;
} else {
if (_e1634 == 2u) {
phi_2910_ = _e1716;
} else {
phi_2910_ = select(_e1724, _e1720, (_e1634 == 3u));
}
let _e1933 = phi_2910_;
phi_2911_ = _e1933;
}
let _e1935 = phi_2911_;
phi_2912_ = _e1935;
}
let _e1937 = phi_2912_;
let _e1942 = (((bitcast<i32>(_e1937) + (_e1927 * _e1695)) + _e1924) * 6i);
let _e1944 = select(_e1456, _e1942, (_e1942 < _e1456));
let _e1950 = global_5.member[bitcast<u32>(select(0i, _e1944, (_e1944 > 0i)))];
let _e1951 = (_e1942 + 1i);
let _e1953 = select(_e1456, _e1951, (_e1951 < _e1456));
let _e1959 = global_5.member[bitcast<u32>(select(0i, _e1953, (_e1953 > 0i)))];
let _e1962 = ((_e1959 >> bitcast<u32>(31i)) != 0u);
if _e1962 {
phi_2971_ = (~(_e1950) + 1u);
} else {
phi_2971_ = _e1950;
}
let _e1968 = phi_2971_;
if _e1962 {
phi_2977_ = (~(_e1959) + select(0u, 1u, (_e1950 == 0u)));
} else {
phi_2977_ = _e1959;
}
let _e1972 = phi_2977_;
let _e1994 = ((((f32(bitcast<i32>(((_e1972 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1972 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1968 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1968 & 65535u)))));
let _e2000 = (_e1942 + 2i);
let _e2002 = select(_e1456, _e2000, (_e2000 < _e1456));
let _e2008 = global_5.member[bitcast<u32>(select(0i, _e2002, (_e2002 > 0i)))];
let _e2009 = (_e1942 + 3i);
let _e2011 = select(_e1456, _e2009, (_e2009 < _e1456));
let _e2017 = global_5.member[bitcast<u32>(select(0i, _e2011, (_e2011 > 0i)))];
let _e2020 = ((_e2017 >> bitcast<u32>(31i)) != 0u);
if _e2020 {
phi_3039_ = (~(_e2008) + 1u);
} else {
phi_3039_ = _e2008;
}
let _e2026 = phi_3039_;
if _e2020 {
phi_3045_ = (~(_e2017) + select(0u, 1u, (_e2008 == 0u)));
} else {
phi_3045_ = _e2017;
}
let _e2030 = phi_3045_;
let _e2052 = ((((f32(bitcast<i32>(((_e2030 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2030 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2026 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2026 & 65535u)))));
let _e2058 = (_e1942 + 4i);
let _e2060 = select(_e1456, _e2058, (_e2058 < _e1456));
let _e2066 = global_5.member[bitcast<u32>(select(0i, _e2060, (_e2060 > 0i)))];
let _e2067 = (_e1942 + 5i);
let _e2069 = select(_e1456, _e2067, (_e2067 < _e1456));
let _e2075 = global_5.member[bitcast<u32>(select(0i, _e2069, (_e2069 > 0i)))];
let _e2078 = ((_e2075 >> bitcast<u32>(31i)) != 0u);
if _e2078 {
phi_3107_ = (~(_e2066) + 1u);
} else {
phi_3107_ = _e2066;
}
let _e2084 = phi_3107_;
if _e2078 {
phi_3113_ = (~(_e2075) + select(0u, 1u, (_e2066 == 0u)));
} else {
phi_3113_ = _e2075;
}
let _e2088 = phi_3113_;
let _e2110 = ((((f32(bitcast<i32>(((_e2088 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2088 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2084 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2084 & 65535u)))));
let _e2122 = (_e1680 + 1i);
if _e1698 {
phi_3169_ = (_e1695 - 1i);
} else {
phi_3169_ = _e1697;
}
let _e2125 = phi_3169_;
let _e2127 = select(_e2122, 0i, (_e2122 < 0i));
let _e2128 = (_e2127 >= _e1702);
if _e2128 {
phi_3181_ = (_e1702 - 1i);
} else {
phi_3181_ = _e2127;
}
let _e2131 = phi_3181_;
if _e1725 {
phi_3213_ = 0u;
} else {
if (_e1634 == 1u) {
phi_3212_ = _e1712;
} else {
if (_e1634 == 2u) {
phi_3211_ = _e1716;
} else {
phi_3211_ = select(_e1724, _e1720, (_e1634 == 3u));
}
let _e2137 = phi_3211_;
phi_3212_ = _e2137;
}
let _e2139 = phi_3212_;
phi_3213_ = _e2139;
}
let _e2141 = phi_3213_;
let _e2146 = (((bitcast<i32>(_e2141) + (_e2131 * _e1695)) + _e2125) * 6i);
let _e2148 = select(_e1456, _e2146, (_e2146 < _e1456));
let _e2154 = global_5.member[bitcast<u32>(select(0i, _e2148, (_e2148 > 0i)))];
let _e2155 = (_e2146 + 1i);
let _e2157 = select(_e1456, _e2155, (_e2155 < _e1456));
let _e2163 = global_5.member[bitcast<u32>(select(0i, _e2157, (_e2157 > 0i)))];
let _e2166 = ((_e2163 >> bitcast<u32>(31i)) != 0u);
if _e2166 {
phi_3272_ = (~(_e2154) + 1u);
} else {
phi_3272_ = _e2154;
}
let _e2172 = phi_3272_;
if _e2166 {
phi_3278_ = (~(_e2163) + select(0u, 1u, (_e2154 == 0u)));
} else {
phi_3278_ = _e2163;
}
let _e2176 = phi_3278_;
let _e2198 = ((((f32(bitcast<i32>(((_e2176 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2176 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2172 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2172 & 65535u)))));
let _e2204 = (_e2146 + 2i);
let _e2206 = select(_e1456, _e2204, (_e2204 < _e1456));
let _e2212 = global_5.member[bitcast<u32>(select(0i, _e2206, (_e2206 > 0i)))];
let _e2213 = (_e2146 + 3i);
let _e2215 = select(_e1456, _e2213, (_e2213 < _e1456));
let _e2221 = global_5.member[bitcast<u32>(select(0i, _e2215, (_e2215 > 0i)))];
let _e2224 = ((_e2221 >> bitcast<u32>(31i)) != 0u);
if _e2224 {
phi_3340_ = (~(_e2212) + 1u);
} else {
phi_3340_ = _e2212;
}
let _e2230 = phi_3340_;
if _e2224 {
phi_3346_ = (~(_e2221) + select(0u, 1u, (_e2212 == 0u)));
} else {
phi_3346_ = _e2221;
}
let _e2234 = phi_3346_;
let _e2256 = ((((f32(bitcast<i32>(((_e2234 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2234 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2230 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2230 & 65535u)))));
let _e2262 = (_e2146 + 4i);
let _e2264 = select(_e1456, _e2262, (_e2262 < _e1456));
let _e2270 = global_5.member[bitcast<u32>(select(0i, _e2264, (_e2264 > 0i)))];
let _e2271 = (_e2146 + 5i);
let _e2273 = select(_e1456, _e2271, (_e2271 < _e1456));
let _e2279 = global_5.member[bitcast<u32>(select(0i, _e2273, (_e2273 > 0i)))];
let _e2282 = ((_e2279 >> bitcast<u32>(31i)) != 0u);
if _e2282 {
phi_3408_ = (~(_e2270) + 1u);
} else {
phi_3408_ = _e2270;
}
let _e2288 = phi_3408_;
if _e2282 {
phi_3414_ = (~(_e2279) + select(0u, 1u, (_e2270 == 0u)));
} else {
phi_3414_ = _e2279;
}
let _e2292 = phi_3414_;
let _e2314 = ((((f32(bitcast<i32>(((_e2292 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2292 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2288 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2288 & 65535u)))));
if _e1921 {
phi_3469_ = (_e1695 - 1i);
} else {
phi_3469_ = _e1920;
}
let _e2325 = phi_3469_;
if _e2128 {
phi_3481_ = (_e1702 - 1i);
} else {
phi_3481_ = _e2127;
}
let _e2328 = phi_3481_;
if _e1725 {
phi_3513_ = 0u;
} else {
if (_e1634 == 1u) {
phi_3512_ = _e1712;
} else {
if (_e1634 == 2u) {
phi_3511_ = _e1716;
} else {
phi_3511_ = select(_e1724, _e1720, (_e1634 == 3u));
}
let _e2334 = phi_3511_;
phi_3512_ = _e2334;
}
let _e2336 = phi_3512_;
phi_3513_ = _e2336;
}
let _e2338 = phi_3513_;
let _e2343 = (((bitcast<i32>(_e2338) + (_e2328 * _e1695)) + _e2325) * 6i);
let _e2345 = select(_e1456, _e2343, (_e2343 < _e1456));
let _e2351 = global_5.member[bitcast<u32>(select(0i, _e2345, (_e2345 > 0i)))];
let _e2352 = (_e2343 + 1i);
let _e2354 = select(_e1456, _e2352, (_e2352 < _e1456));
let _e2360 = global_5.member[bitcast<u32>(select(0i, _e2354, (_e2354 > 0i)))];
let _e2363 = ((_e2360 >> bitcast<u32>(31i)) != 0u);
if _e2363 {
phi_3572_ = (~(_e2351) + 1u);
} else {
phi_3572_ = _e2351;
}
let _e2369 = phi_3572_;
if _e2363 {
phi_3578_ = (~(_e2360) + select(0u, 1u, (_e2351 == 0u)));
} else {
phi_3578_ = _e2360;
}
let _e2373 = phi_3578_;
let _e2395 = ((((f32(bitcast<i32>(((_e2373 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2373 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2369 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2369 & 65535u)))));
let _e2401 = (_e2343 + 2i);
let _e2403 = select(_e1456, _e2401, (_e2401 < _e1456));
let _e2409 = global_5.member[bitcast<u32>(select(0i, _e2403, (_e2403 > 0i)))];
let _e2410 = (_e2343 + 3i);
let _e2412 = select(_e1456, _e2410, (_e2410 < _e1456));
let _e2418 = global_5.member[bitcast<u32>(select(0i, _e2412, (_e2412 > 0i)))];
let _e2421 = ((_e2418 >> bitcast<u32>(31i)) != 0u);
if _e2421 {
phi_3640_ = (~(_e2409) + 1u);
} else {
phi_3640_ = _e2409;
}
let _e2427 = phi_3640_;
if _e2421 {
phi_3646_ = (~(_e2418) + select(0u, 1u, (_e2409 == 0u)));
} else {
phi_3646_ = _e2418;
}
let _e2431 = phi_3646_;
let _e2453 = ((((f32(bitcast<i32>(((_e2431 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2431 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2427 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2427 & 65535u)))));
let _e2459 = (_e2343 + 4i);
let _e2461 = select(_e1456, _e2459, (_e2459 < _e1456));
let _e2467 = global_5.member[bitcast<u32>(select(0i, _e2461, (_e2461 > 0i)))];
let _e2468 = (_e2343 + 5i);
let _e2470 = select(_e1456, _e2468, (_e2468 < _e1456));
let _e2476 = global_5.member[bitcast<u32>(select(0i, _e2470, (_e2470 > 0i)))];
let _e2479 = ((_e2476 >> bitcast<u32>(31i)) != 0u);
if _e2479 {
phi_3708_ = (~(_e2467) + 1u);
} else {
phi_3708_ = _e2467;
}
let _e2485 = phi_3708_;
if _e2479 {
phi_3714_ = (~(_e2476) + select(0u, 1u, (_e2467 == 0u)));
} else {
phi_3714_ = _e2476;
}
let _e2489 = phi_3714_;
let _e2511 = ((((f32(bitcast<i32>(((_e2489 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2489 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2485 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2485 & 65535u)))));
let _e2523 = (1f - _e1684);
phi_2466_ = vec3<f32>((_e1632.x + ((((select(_e1792, -(bitcast<f32>((bitcast<u32>(_e1792) & 2147483647u))), _e1760) * _e1914) + (select(_e1994, -(bitcast<f32>((bitcast<u32>(_e1994) & 2147483647u))), _e1962) * _e1682)) * _e2523) + (((select(_e2198, -(bitcast<f32>((bitcast<u32>(_e2198) & 2147483647u))), _e2166) * _e1914) + (select(_e2395, -(bitcast<f32>((bitcast<u32>(_e2395) & 2147483647u))), _e2363) * _e1682)) * _e1684))), (_e1632.y + ((((select(_e1850, -(bitcast<f32>((bitcast<u32>(_e1850) & 2147483647u))), _e1818) * _e1914) + (select(_e2052, -(bitcast<f32>((bitcast<u32>(_e2052) & 2147483647u))), _e2020) * _e1682)) * _e2523) + (((select(_e2256, -(bitcast<f32>((bitcast<u32>(_e2256) & 2147483647u))), _e2224) * _e1914) + (select(_e2453, -(bitcast<f32>((bitcast<u32>(_e2453) & 2147483647u))), _e2421) * _e1682)) * _e1684))), (_e1632.z + ((((select(_e1908, -(bitcast<f32>((bitcast<u32>(_e1908) & 2147483647u))), _e1876) * _e1914) + (select(_e2110, -(bitcast<f32>((bitcast<u32>(_e2110) & 2147483647u))), _e2078) * _e1682)) * _e2523) + (((select(_e2314, -(bitcast<f32>((bitcast<u32>(_e2314) & 2147483647u))), _e2282) * _e1914) + (select(_e2511, -(bitcast<f32>((bitcast<u32>(_e2511) & 2147483647u))), _e2479) * _e1682)) * _e1684))));
phi_2469_ = (_e1634 + 1u);
} else {
phi_2466_ = vec3<f32>();
phi_2469_ = u32();
}
let _e2542 = phi_2466_;
let _e2544 = phi_2469_;
continue;
continuing {
phi_2465_ = _e2542;
phi_2468_ = _e2544;
break if !(_e1637);
}
}
let _e2547 = local_4;
let _e2551 = local_5;
let _e2555 = local_6;
let _e2558 = ((_e2547.x * _e1430) + _e206);
let _e2559 = ((_e2551.y * _e1430) + _e217);
let _e2560 = ((_e2555.z * _e1430) + _e228);
let _e2561 = (_e140 - _e2558);
let _e2562 = (_e151 - _e2559);
let _e2563 = (_e162 - _e2560);
let _e2581 = global_2.member.member_2.member;
let _e2582 = (((((f32(_e306) + 0.5f) / f32(_e316)) * 2f) - 1f) * _e2581);
let _e2590 = global_2.member.member_2.member_1;
let _e2591 = ((1f - (((f32(_e307) + 0.5f) / f32(_e323)) * 2f)) * _e2590);
let _e2594 = global_2.member.member_3;
let _e2603 = global_2.member.member_4;
let _e2616 = global_2.member.member_2.member_3;
let _e2617 = (_e2616 != 0u);
let _e2620 = global_2.member.member_5;
let _e2627 = select((_e2620.member + ((_e2594.member * _e2582) + (_e2603.member * _e2591))), _e2620.member, _e2617);
let _e2628 = select((_e2620.member_1 + ((_e2594.member_1 * _e2582) + (_e2603.member_1 * _e2591))), _e2620.member_1, _e2617);
let _e2629 = select((_e2620.member_2 + ((_e2594.member_2 * _e2582) + (_e2603.member_2 * _e2591))), _e2620.member_2, _e2617);
let _e2639 = (((_e2627 * _e2627) + (_e2628 * _e2628)) + (_e2629 * _e2629));
let _e2670 = select(0f, _e272, (_e272 > 0f));
let _e2678 = global_2.member.member_7;
global_1.member[_e74] = (((_e107 + select(0f, _e2561, (_e2561 > 0f))) + _e1443) + _e239);
global_1.member[(_e72 + _e74)] = (((_e118 + select(0f, _e2562, (_e2562 > 0f))) + _e1444) + _e250);
global_1.member[((2u * _e72) + _e74)] = (((_e129 + select(0f, _e2563, (_e2563 > 0f))) + _e1445) + _e261);
global_1.member[((3u * _e72) + _e74)] = select(1f, _e2670, (_e2670 < 1f));
global_1.member[((4u * _e72) + _e74)] = _e107;
global_1.member[((5u * _e72) + _e74)] = _e118;
global_1.member[((6u * _e72) + _e74)] = _e129;
global_1.member[((7u * _e72) + _e74)] = _e140;
global_1.member[((8u * _e72) + _e74)] = _e151;
global_1.member[((9u * _e72) + _e74)] = _e162;
global_1.member[((10u * _e72) + _e74)] = _e1443;
global_1.member[((11u * _e72) + _e74)] = _e1444;
global_1.member[((12u * _e72) + _e74)] = _e1445;
global_1.member[((13u * _e72) + _e74)] = _e2558;
global_1.member[((14u * _e72) + _e74)] = _e2559;
global_1.member[((15u * _e72) + _e74)] = _e2560;
global_1.member[((16u * _e72) + _e74)] = _e239;
global_1.member[((17u * _e72) + _e74)] = _e250;
global_1.member[((18u * _e72) + _e74)] = _e261;
global_1.member[((19u * _e72) + _e74)] = select(0f, ((_e96 * ((((_e2620.member * _e2627) + (_e2620.member_1 * _e2628)) + (_e2620.member_2 * _e2629)) / sqrt(select(0f, _e2639, (_e2639 > 0f))))) * _e2678), (_e96 < (0.5f * 1e30f)));
global_1.member[((20u * _e72) + _e74)] = (((_e2594.member * _e283) + (_e2594.member_1 * _e294)) + (_e2594.member_2 * _e305));
global_1.member[((21u * _e72) + _e74)] = (((_e2603.member * _e283) + (_e2603.member_1 * _e294)) + (_e2603.member_2 * _e305));
global_1.member[((22u * _e72) + _e74)] = -((((_e2620.member * _e283) + (_e2620.member_1 * _e294)) + (_e2620.member_2 * _e305)));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
