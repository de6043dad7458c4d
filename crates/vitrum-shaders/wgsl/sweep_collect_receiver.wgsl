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
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_11 {
member: u32,
member_1: u32,
}
struct type_12 {
member: type_11,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_13 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_14 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_11,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_11,
member_18: type_12,
member_19: type_5,
member_20: type_13,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: array<f32>,
}
struct type_19 {
member: array<u32>,
}
struct type_20 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_21 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_22 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: i32,
member_10: i32,
member_11: type_2,
member_12: u32,
member_13: type_2,
member_14: u32,
member_15: u32,
}
struct type_23 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_24 {
member: type_5,
member_1: type_5,
}
struct type_25 {
member: type_7,
member_1: u32,
}
struct type_26 {
member: type_2,
member_1: u32,
member_2: type_20,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_21,
member_8: type_22,
member_9: type_22,
member_10: type_23,
member_11: type_24,
member_12: type_14,
member_13: type_21,
member_14: type_4,
member_15: type_9,
member_16: type_25,
member_17: type_25,
member_18: type_25,
member_19: type_25,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_27 {
member: type_26,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_27;
@group(0) @binding(2)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage, read_write> global_3: type_16;
@group(0) @binding(1)
var<storage> global_4: type_19;
fn function_() {
var phi_1256_: f32;
var phi_1312_: f32;
var phi_1355_: u32;
var phi_1361_: u32;
var phi_1423_: u32;
var phi_1429_: u32;
var phi_1491_: u32;
var phi_1497_: u32;
let _e36 = global;
let _e43 = global_1.member.member_2;
let _e46 = global_1.member.member;
let _e54 = (_e36.x + _e43.member);
let _e56 = (_e36.y + _e43.member_1);
if (_e54 < _e43.member_2) {
if (_e56 < _e43.member_3) {
let _e59 = (_e46.member * _e46.member_1);
let _e61 = ((_e56 * _e46.member) + _e54);
let _e63 = f32(bitcast<i32>(_e54));
let _e65 = f32(bitcast<i32>(_e56));
let _e70 = global_1.member.member_12.member_4.member;
let _e75 = global_1.member.member_12.member_4.member_1;
let _e78 = f32(bitcast<i32>(_e70));
let _e83 = global_1.member.member_12.member_18.member_1;
let _e84 = (_e78 * _e83);
let _e89 = global_1.member.member_12.member_18.member_2;
let _e90 = ((_e63 + 1f) - _e89);
let _e92 = select(0f, _e90, (_e90 > 0f));
let _e95 = (_e90 - _e84);
let _e97 = select(0f, _e95, (_e95 > 0f));
let _e99 = (_e89 - _e97);
let _e100 = (_e89 * 1e-6f);
let _e105 = -(_e90);
let _e107 = select(0f, _e105, (_e105 > 0f));
let _e109 = (_e89 - _e107);
let _e115 = (_e63 - _e89);
let _e117 = select(0f, _e115, (_e115 > 0f));
let _e120 = (_e115 - _e84);
let _e122 = select(0f, _e120, (_e120 > 0f));
let _e124 = (_e89 - _e122);
let _e129 = -(_e115);
let _e131 = select(0f, _e129, (_e129 > 0f));
let _e133 = (_e89 - _e131);
let _e142 = f32(bitcast<i32>(_e75));
let _e143 = (_e142 * _e83);
let _e144 = ((_e65 + 1f) - _e89);
let _e146 = select(0f, _e144, (_e144 > 0f));
let _e149 = (_e144 - _e143);
let _e151 = select(0f, _e149, (_e149 > 0f));
let _e153 = (_e89 - _e151);
let _e158 = -(_e144);
let _e160 = select(0f, _e158, (_e158 > 0f));
let _e162 = (_e89 - _e160);
let _e168 = (_e65 - _e89);
let _e170 = select(0f, _e168, (_e168 > 0f));
let _e173 = (_e168 - _e143);
let _e175 = select(0f, _e173, (_e173 > 0f));
let _e177 = (_e89 - _e175);
let _e182 = -(_e168);
let _e184 = select(0f, _e182, (_e182 > 0f));
let _e186 = (_e89 - _e184);
let _e195 = ((_e63 + 0.5f) - _e89);
let _e197 = select(0f, _e195, (_e195 > 0f));
let _e200 = (_e195 - _e84);
let _e202 = select(0f, _e200, (_e200 > 0f));
let _e204 = (_e89 - _e202);
let _e209 = -(_e195);
let _e211 = select(0f, _e209, (_e209 > 0f));
let _e213 = (_e89 - _e211);
let _e218 = (((select(_e84, _e197, (_e197 < _e84)) + ((_e202 * _e89) / select(_e100, _e204, (_e204 > _e100)))) - ((_e211 * _e89) / select(_e100, _e213, (_e213 > _e100)))) / _e83);
let _e220 = ((_e65 + 0.5f) - _e89);
let _e222 = select(0f, _e220, (_e220 > 0f));
let _e225 = (_e220 - _e143);
let _e227 = select(0f, _e225, (_e225 > 0f));
let _e229 = (_e89 - _e227);
let _e234 = -(_e220);
let _e236 = select(0f, _e234, (_e234 > 0f));
let _e238 = (_e89 - _e236);
let _e243 = (((select(_e143, _e222, (_e222 < _e143)) + ((_e227 * _e89) / select(_e100, _e229, (_e229 > _e100)))) - ((_e236 * _e89) / select(_e100, _e238, (_e238 > _e100)))) / _e83);
let _e251 = (_e78 - 1f);
let _e253 = select(0f, _e218, (_e218 > 0f));
let _e255 = select(_e251, _e253, (_e253 < _e251));
let _e262 = select(0i, select(select(i32(_e255), i32(-2147483648), (_e255 < -2147483600f)), 2147483647i, (_e255 > 2147483500f)), (_e255 == _e255));
let _e266 = (_e262 - select(0i, 1i, (_e255 < f32(_e262))));
let _e267 = (_e142 - 1f);
let _e269 = select(0f, _e243, (_e243 > 0f));
let _e271 = select(_e267, _e269, (_e269 < _e267));
let _e278 = select(0i, select(select(i32(_e271), i32(-2147483648), (_e271 < -2147483600f)), 2147483647i, (_e271 > 2147483500f)), (_e271 == _e271));
let _e282 = (_e278 - select(0i, 1i, (_e271 < f32(_e278))));
let _e284 = (_e218 - f32(_e266));
let _e286 = (_e243 - f32(_e282));
let _e287 = bitcast<u32>(_e266);
let _e288 = bitcast<u32>(_e282);
let _e289 = (_e70 + 1u);
let _e292 = bitcast<i32>((_e289 * (_e75 + 1u)));
let _e293 = (6i * _e292);
let _e294 = (_e288 * _e289);
let _e296 = bitcast<i32>((_e294 + _e287));
let _e297 = (_e293 + _e296);
let _e299 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e301 = select(_e299, _e297, (_e297 < _e299));
let _e307 = global_2.member[bitcast<u32>(select(0i, _e301, (_e301 > 0i)))];
let _e308 = (_e297 + _e292);
let _e310 = select(_e299, _e308, (_e308 < _e299));
let _e316 = global_2.member[bitcast<u32>(select(0i, _e310, (_e310 > 0i)))];
let _e317 = (2i * _e292);
let _e318 = (_e297 + _e317);
let _e320 = select(_e299, _e318, (_e318 < _e299));
let _e326 = global_2.member[bitcast<u32>(select(0i, _e320, (_e320 > 0i)))];
let _e327 = (1f - _e284);
let _e331 = (_e287 + 1u);
let _e333 = bitcast<i32>((_e294 + _e331));
let _e334 = (_e293 + _e333);
let _e336 = select(_e299, _e334, (_e334 < _e299));
let _e342 = global_2.member[bitcast<u32>(select(0i, _e336, (_e336 > 0i)))];
let _e343 = (_e334 + _e292);
let _e345 = select(_e299, _e343, (_e343 < _e299));
let _e351 = global_2.member[bitcast<u32>(select(0i, _e345, (_e345 > 0i)))];
let _e352 = (_e334 + _e317);
let _e354 = select(_e299, _e352, (_e352 < _e299));
let _e360 = global_2.member[bitcast<u32>(select(0i, _e354, (_e354 > 0i)))];
let _e368 = ((_e288 + 1u) * _e289);
let _e370 = bitcast<i32>((_e368 + _e287));
let _e371 = (_e293 + _e370);
let _e373 = select(_e299, _e371, (_e371 < _e299));
let _e379 = global_2.member[bitcast<u32>(select(0i, _e373, (_e373 > 0i)))];
let _e380 = (_e371 + _e292);
let _e382 = select(_e299, _e380, (_e380 < _e299));
let _e388 = global_2.member[bitcast<u32>(select(0i, _e382, (_e382 > 0i)))];
let _e389 = (_e371 + _e317);
let _e391 = select(_e299, _e389, (_e389 < _e299));
let _e397 = global_2.member[bitcast<u32>(select(0i, _e391, (_e391 > 0i)))];
let _e402 = bitcast<i32>((_e368 + _e331));
let _e403 = (_e293 + _e402);
let _e405 = select(_e299, _e403, (_e403 < _e299));
let _e411 = global_2.member[bitcast<u32>(select(0i, _e405, (_e405 > 0i)))];
let _e412 = (_e403 + _e292);
let _e414 = select(_e299, _e412, (_e412 < _e299));
let _e420 = global_2.member[bitcast<u32>(select(0i, _e414, (_e414 > 0i)))];
let _e421 = (_e403 + _e317);
let _e423 = select(_e299, _e421, (_e421 < _e299));
let _e429 = global_2.member[bitcast<u32>(select(0i, _e423, (_e423 > 0i)))];
let _e436 = (1f - _e286);
let _e446 = (10i * _e292);
let _e447 = (_e446 + _e296);
let _e449 = select(_e299, _e447, (_e447 < _e299));
let _e455 = global_2.member[bitcast<u32>(select(0i, _e449, (_e449 > 0i)))];
let _e456 = (11i * _e292);
let _e457 = (_e456 + _e296);
let _e459 = select(_e299, _e457, (_e457 < _e299));
let _e465 = global_2.member[bitcast<u32>(select(0i, _e459, (_e459 > 0i)))];
let _e469 = (_e446 + _e333);
let _e471 = select(_e299, _e469, (_e469 < _e299));
let _e477 = global_2.member[bitcast<u32>(select(0i, _e471, (_e471 > 0i)))];
let _e478 = (_e456 + _e333);
let _e480 = select(_e299, _e478, (_e478 < _e299));
let _e486 = global_2.member[bitcast<u32>(select(0i, _e480, (_e480 > 0i)))];
let _e491 = (_e446 + _e370);
let _e493 = select(_e299, _e491, (_e491 < _e299));
let _e499 = global_2.member[bitcast<u32>(select(0i, _e493, (_e493 > 0i)))];
let _e500 = (_e456 + _e370);
let _e502 = select(_e299, _e500, (_e500 < _e299));
let _e508 = global_2.member[bitcast<u32>(select(0i, _e502, (_e502 > 0i)))];
let _e513 = (_e446 + _e402);
let _e515 = select(_e299, _e513, (_e513 < _e299));
let _e521 = global_2.member[bitcast<u32>(select(0i, _e515, (_e515 > 0i)))];
let _e522 = (_e456 + _e402);
let _e524 = select(_e299, _e522, (_e522 < _e299));
let _e530 = global_2.member[bitcast<u32>(select(0i, _e524, (_e524 > 0i)))];
let _e535 = select(0f, 1f, (((((_e455 == 0f) && (_e465 != 1f)) && ((_e477 == 0f) && (_e486 != 1f))) && ((_e499 == 0f) && (_e508 != 1f))) && ((_e521 == 0f) && (_e530 != 1f))));
let _e542 = global_1.member.member_12.member_23;
let _e547 = global_1.member.member_12.member_3;
let _e548 = (_e547 == 0u);
if _e548 {
phi_1256_ = 1f;
} else {
let _e552 = global_1.member.member_12.member_5;
let _e556 = global_1.member.member_12.member_7;
let _e558 = (_e552 + (_e218 * _e556));
let _e562 = global_1.member.member_12.member_6;
let _e564 = (_e562 + (_e243 * _e556));
let _e569 = global_1.member.member_12.member_20.member;
let _e577 = (((_e569.member * _e558) + (_e569.member_1 * _e564)) + (_e569.member_2 * 1f));
let _e581 = (_e558 - (_e569.member * _e577));
let _e582 = (_e564 - (_e569.member_1 * _e577));
let _e583 = (1f - (_e569.member_2 * _e577));
let _e588 = (((_e581 * _e581) + (_e582 * _e582)) + (_e583 * _e583));
let _e599 = global_1.member.member_12.member_20.member_1;
let _e605 = global_1.member.member_12.member_20.member_2;
let _e606 = ((_e599 - (sqrt(select(0f, _e588, (_e588 > 0f))) / select(1e-20f, _e577, (_e577 > 1e-20f)))) * _e605);
let _e608 = select(0f, _e606, (_e606 > 0f));
let _e610 = select(1f, _e608, (_e608 < 1f));
phi_1256_ = select(1f, select(0f, ((_e610 * _e610) * (3f - (2f * _e610))), (_e577 > 0f)), (_e605 > 0f));
}
let _e620 = phi_1256_;
let _e621 = (((((_e218 >= 0f) && (_e218 <= _e78)) && (_e243 >= 0f)) && (_e243 <= _e142)) && (_e542 == 0f));
let _e631 = global_1.member.member.member;
let _e635 = bitcast<i32>((((_e56 * _e631) + _e54) * 6u));
if _e548 {
phi_1312_ = 1f;
} else {
let _e640 = global_1.member.member_12.member_5;
let _e644 = global_1.member.member_12.member_7;
let _e646 = (_e640 + (_e218 * _e644));
let _e650 = global_1.member.member_12.member_6;
let _e652 = (_e650 + (_e243 * _e644));
let _e657 = (((_e646 * _e646) + (_e652 * _e652)) + (1f * 1f));
let _e661 = (1f / sqrt(select(0f, _e657, (_e657 > 0f))));
phi_1312_ = ((_e661 * _e661) * _e661);
}
let _e665 = phi_1312_;
let _e667 = (1f / (((((((select(_e84, _e92, (_e92 < _e84)) + ((_e97 * _e89) / select(_e100, _e99, (_e99 > _e100)))) - ((_e107 * _e89) / select(_e100, _e109, (_e109 > _e100)))) / _e83) - (((select(_e84, _e117, (_e117 < _e84)) + ((_e122 * _e89) / select(_e100, _e124, (_e124 > _e100)))) - ((_e131 * _e89) / select(_e100, _e133, (_e133 > _e100)))) / _e83)) * ((((select(_e143, _e146, (_e146 < _e143)) + ((_e151 * _e89) / select(_e100, _e153, (_e153 > _e100)))) - ((_e160 * _e89) / select(_e100, _e162, (_e162 > _e100)))) / _e83) - (((select(_e143, _e170, (_e170 < _e143)) + ((_e175 * _e89) / select(_e100, _e177, (_e177 > _e100)))) - ((_e184 * _e89) / select(_e100, _e186, (_e186 > _e100)))) / _e83))) * 16777216f) * _e665));
let _e669 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e671 = select(_e669, _e635, (_e635 < _e669));
let _e677 = global_4.member[bitcast<u32>(select(0i, _e671, (_e671 > 0i)))];
let _e678 = (_e635 + 1i);
let _e680 = select(_e669, _e678, (_e678 < _e669));
let _e686 = global_4.member[bitcast<u32>(select(0i, _e680, (_e680 > 0i)))];
let _e689 = ((_e686 >> bitcast<u32>(31i)) != 0u);
if _e689 {
phi_1355_ = (~(_e677) + 1u);
} else {
phi_1355_ = _e677;
}
let _e695 = phi_1355_;
if _e689 {
phi_1361_ = (~(_e686) + select(0u, 1u, (_e677 == 0u)));
} else {
phi_1361_ = _e686;
}
let _e699 = phi_1361_;
let _e721 = ((((f32(bitcast<i32>(((_e699 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e699 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e695 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e695 & 65535u)))));
let _e727 = (_e635 + 2i);
let _e729 = select(_e669, _e727, (_e727 < _e669));
let _e735 = global_4.member[bitcast<u32>(select(0i, _e729, (_e729 > 0i)))];
let _e736 = (_e635 + 3i);
let _e738 = select(_e669, _e736, (_e736 < _e669));
let _e744 = global_4.member[bitcast<u32>(select(0i, _e738, (_e738 > 0i)))];
let _e747 = ((_e744 >> bitcast<u32>(31i)) != 0u);
if _e747 {
phi_1423_ = (~(_e735) + 1u);
} else {
phi_1423_ = _e735;
}
let _e753 = phi_1423_;
if _e747 {
phi_1429_ = (~(_e744) + select(0u, 1u, (_e735 == 0u)));
} else {
phi_1429_ = _e744;
}
let _e757 = phi_1429_;
let _e779 = ((((f32(bitcast<i32>(((_e757 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e757 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e753 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e753 & 65535u)))));
let _e785 = (_e635 + 4i);
let _e787 = select(_e669, _e785, (_e785 < _e669));
let _e793 = global_4.member[bitcast<u32>(select(0i, _e787, (_e787 > 0i)))];
let _e794 = (_e635 + 5i);
let _e796 = select(_e669, _e794, (_e794 < _e669));
let _e802 = global_4.member[bitcast<u32>(select(0i, _e796, (_e796 > 0i)))];
let _e805 = ((_e802 >> bitcast<u32>(31i)) != 0u);
if _e805 {
phi_1491_ = (~(_e793) + 1u);
} else {
phi_1491_ = _e793;
}
let _e811 = phi_1491_;
if _e805 {
phi_1497_ = (~(_e802) + select(0u, 1u, (_e793 == 0u)));
} else {
phi_1497_ = _e802;
}
let _e815 = phi_1497_;
let _e837 = ((((f32(bitcast<i32>(((_e815 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e815 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e811 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e811 & 65535u)))));
let _e846 = ((select(1f, (((((_e307 * _e327) + (_e342 * _e284)) * _e436) + (((_e379 * _e327) + (_e411 * _e284)) * _e286)) * _e535), _e621) * _e620) + (select(_e721, -(bitcast<f32>((bitcast<u32>(_e721) & 2147483647u))), _e689) * _e667));
let _e847 = ((select(1f, (((((_e316 * _e327) + (_e351 * _e284)) * _e436) + (((_e388 * _e327) + (_e420 * _e284)) * _e286)) * _e535), _e621) * _e620) + (select(_e779, -(bitcast<f32>((bitcast<u32>(_e779) & 2147483647u))), _e747) * _e667));
let _e848 = ((select(1f, (((((_e326 * _e327) + (_e360 * _e284)) * _e436) + (((_e397 * _e327) + (_e429 * _e284)) * _e286)) * _e535), _e621) * _e620) + (select(_e837, -(bitcast<f32>((bitcast<u32>(_e837) & 2147483647u))), _e805) * _e667));
let _e856 = select(0f, _e620, (_e547 != 0u));
global_3.member[_e61] = (select(0f, _e846, (_e846 > 0f)) - _e856);
global_3.member[(_e59 + _e61)] = (select(0f, _e847, (_e847 > 0f)) - _e856);
global_3.member[((2u * _e59) + _e61)] = (select(0f, _e848, (_e848 > 0f)) - _e856);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
