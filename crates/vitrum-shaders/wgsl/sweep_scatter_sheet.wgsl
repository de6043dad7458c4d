struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_6 {
member: array<f32>,
}
struct type_11 {
member: type_4,
member_1: type_4,
member_2: type_4,
member_3: type_4,
member_4: type_4,
member_5: vec4<i32>,
member_6: vec4<i32>,
member_7: vec4<i32>,
}
struct type_12 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
member_4: type_4,
member_5: type_11,
member_6: type_11,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: type_4,
member_11: type_4,
member_12: type_4,
member_13: type_4,
member_14: type_4,
member_15: type_4,
member_16: type_4,
member_17: type_4,
member_18: type_4,
member_19: type_4,
member_20: type_4,
member_21: type_4,
member_22: type_4,
member_23: type_4,
member_24: type_4,
member_25: vec4<u32>,
member_26: type_4,
member_27: type_4,
member_28: type_4,
member_29: type_4,
member_30: type_4,
member_31: type_4,
}
struct type_13 {
member: type_12,
}
struct type_15 {
member: vec2<f32>,
member_1: vec2<f32>,
member_2: vec2<f32>,
member_3: vec3<f32>,
member_4: bool,
}
struct type_18 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_13;
@group(0) @binding(1)
var<storage> global_2: type_6;
@group(0) @binding(2)
var<storage> global_3: type_6;
@group(0) @binding(3)
var<storage, read_write> global_4: type_18;
fn function_() {
var local: u32;
var local_1: u32;
var local_2: u32;
var local_3: u32;
var local_4: u32;
var local_5: u32;
var local_6: u32;
var local_7: u32;
var phi_1722_: i32;
var phi_1754_: i32;
var phi_1835_: u32;
var phi_1896_: u32;
var phi_1957_: u32;
var phi_2018_: u32;
var phi_2080_: u32;
var phi_1755_: i32;
var phi_1723_: i32;
var phi_2132_: type_15;
var phi_2136_: type_15;
var phi_2141_: type_15;
var phi_2145_: type_15;
var phi_2149_: type_15;
var phi_2154_: type_15;
var phi_2159_: type_15;
var phi_2163_: type_15;
var phi_2168_: type_15;
var phi_2172_: type_15;
var phi_2176_: type_15;
var phi_2181_: type_15;
var phi_2186_: type_15;
var phi_2190_: type_15;
var phi_2392_: i32;
var phi_2423_: i32;
var phi_2706_: i32;
var phi_2738_: i32;
var phi_2819_: u32;
var phi_2880_: u32;
var phi_2941_: u32;
var phi_3002_: u32;
var phi_3064_: u32;
var phi_2739_: i32;
var phi_2707_: i32;
var phi_2424_: i32;
var phi_2393_: i32;
switch bitcast<i32>(0u) {
default: {
let _e55 = global;
let _e62 = arrayLength((&global_4.member));
let _e65 = global_1.member.member_1;
let _e68 = (_e55.x + _e65.x);
let _e71 = (_e55.y + _e65.y);
if (_e68 < _e65.z) {
if (_e71 < _e65.w) {
let _e79 = global_1.member.member_2[3u];
let _e80 = (_e79 == 0u);
if _e80 {
break;
}
let _e81 = (_e71 / _e79);
let _e83 = (_e71 - (_e81 * _e79));
let _e84 = (_e79 + 1u);
let _e86 = select(1u, _e84, (_e84 > 0u));
let _e88 = ((_e81 * _e86) + _e83);
let _e92 = global_1.member.member_2[2u];
let _e93 = (_e92 + 1u);
let _e98 = global_1.member.member[1u];
if _e80 {
break;
}
let _e100 = ((_e93 * _e86) * (_e98 / _e79));
local_6 = _e100;
let _e101 = (_e88 * _e93);
local_7 = (_e101 + _e68);
let _e105 = (f32(bitcast<i32>(_e68)) - 0.5f);
let _e108 = (f32(bitcast<i32>(_e83)) - 0.5f);
let _e109 = local_7;
let _e110 = bitcast<i32>(_e109);
let _e112 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e114 = select(_e112, _e110, (_e110 < _e112));
let _e119 = global_2.member[bitcast<u32>(select(0i, _e114, (_e114 > 0i)))];
let _e120 = local_6;
let _e121 = local_7;
let _e123 = bitcast<i32>((_e120 + _e121));
let _e125 = select(_e112, _e123, (_e123 < _e112));
let _e130 = global_2.member[bitcast<u32>(select(0i, _e125, (_e125 > 0i)))];
let _e131 = (_e105 + _e119);
let _e132 = (_e108 + _e130);
let _e133 = local_6;
let _e135 = local_7;
let _e137 = bitcast<i32>(((2u * _e133) + _e135));
let _e139 = select(_e112, _e137, (_e137 < _e112));
let _e144 = global_2.member[bitcast<u32>(select(0i, _e139, (_e139 > 0i)))];
let _e145 = local_6;
let _e147 = local_7;
let _e149 = bitcast<i32>(((3u * _e145) + _e147));
let _e151 = select(_e112, _e149, (_e149 < _e112));
let _e156 = global_2.member[bitcast<u32>(select(0i, _e151, (_e151 > 0i)))];
let _e157 = (_e105 + _e144);
let _e158 = (_e108 + _e156);
let _e159 = local_6;
let _e161 = local_7;
let _e163 = bitcast<i32>(((4u * _e159) + _e161));
let _e165 = select(_e112, _e163, (_e163 < _e112));
let _e170 = global_2.member[bitcast<u32>(select(0i, _e165, (_e165 > 0i)))];
let _e171 = local_6;
let _e173 = local_7;
let _e175 = bitcast<i32>(((5u * _e171) + _e173));
let _e177 = select(_e112, _e175, (_e175 < _e112));
let _e182 = global_2.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e183 = local_6;
let _e185 = local_7;
let _e187 = bitcast<i32>(((6u * _e183) + _e185));
let _e189 = select(_e112, _e187, (_e187 < _e112));
let _e194 = global_2.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e197 = (1f / select(1e-6f, _e194, (_e194 > 1e-6f)));
let _e200 = local_6;
let _e202 = local_7;
let _e204 = bitcast<i32>(((7u * _e200) + _e202));
let _e206 = select(_e112, _e204, (_e204 < _e112));
let _e211 = global_2.member[bitcast<u32>(select(0i, _e206, (_e206 > 0i)))];
let _e212 = local_6;
let _e214 = local_7;
let _e216 = bitcast<i32>(((8u * _e212) + _e214));
let _e218 = select(_e112, _e216, (_e216 < _e112));
let _e223 = global_2.member[bitcast<u32>(select(0i, _e218, (_e218 > 0i)))];
let _e224 = local_6;
let _e226 = local_7;
let _e228 = bitcast<i32>(((9u * _e224) + _e226));
let _e230 = select(_e112, _e228, (_e228 < _e112));
let _e235 = global_2.member[bitcast<u32>(select(0i, _e230, (_e230 > 0i)))];
let _e237 = local_6;
let _e239 = local_7;
let _e241 = bitcast<i32>(((10u * _e237) + _e239));
let _e243 = select(_e112, _e241, (_e241 < _e112));
let _e248 = global_2.member[bitcast<u32>(select(0i, _e243, (_e243 > 0i)))];
let _e249 = (_e248 != 0f);
let _e253 = type_15(vec2<f32>(_e131, _e132), vec2<f32>(_e157, _e158), vec2<f32>((_e170 * _e197), (_e182 * _e197)), vec3<f32>(_e211, _e223, _e235), _e249);
let _e254 = (_e68 + 1u);
if _e80 {
break;
}
local_4 = _e100;
local_5 = (_e101 + _e254);
let _e258 = (f32(bitcast<i32>(_e254)) - 0.5f);
let _e259 = local_5;
let _e260 = bitcast<i32>(_e259);
let _e262 = select(_e112, _e260, (_e260 < _e112));
let _e267 = global_2.member[bitcast<u32>(select(0i, _e262, (_e262 > 0i)))];
let _e268 = local_4;
let _e269 = local_5;
let _e271 = bitcast<i32>((_e268 + _e269));
let _e273 = select(_e112, _e271, (_e271 < _e112));
let _e278 = global_2.member[bitcast<u32>(select(0i, _e273, (_e273 > 0i)))];
let _e279 = (_e258 + _e267);
let _e280 = (_e108 + _e278);
let _e281 = local_4;
let _e283 = local_5;
let _e285 = bitcast<i32>(((2u * _e281) + _e283));
let _e287 = select(_e112, _e285, (_e285 < _e112));
let _e292 = global_2.member[bitcast<u32>(select(0i, _e287, (_e287 > 0i)))];
let _e293 = local_4;
let _e295 = local_5;
let _e297 = bitcast<i32>(((3u * _e293) + _e295));
let _e299 = select(_e112, _e297, (_e297 < _e112));
let _e304 = global_2.member[bitcast<u32>(select(0i, _e299, (_e299 > 0i)))];
let _e305 = (_e258 + _e292);
let _e306 = (_e108 + _e304);
let _e307 = local_4;
let _e309 = local_5;
let _e311 = bitcast<i32>(((4u * _e307) + _e309));
let _e313 = select(_e112, _e311, (_e311 < _e112));
let _e318 = global_2.member[bitcast<u32>(select(0i, _e313, (_e313 > 0i)))];
let _e319 = local_4;
let _e321 = local_5;
let _e323 = bitcast<i32>(((5u * _e319) + _e321));
let _e325 = select(_e112, _e323, (_e323 < _e112));
let _e330 = global_2.member[bitcast<u32>(select(0i, _e325, (_e325 > 0i)))];
let _e331 = local_4;
let _e333 = local_5;
let _e335 = bitcast<i32>(((6u * _e331) + _e333));
let _e337 = select(_e112, _e335, (_e335 < _e112));
let _e342 = global_2.member[bitcast<u32>(select(0i, _e337, (_e337 > 0i)))];
let _e345 = (1f / select(1e-6f, _e342, (_e342 > 1e-6f)));
let _e348 = local_4;
let _e350 = local_5;
let _e352 = bitcast<i32>(((7u * _e348) + _e350));
let _e354 = select(_e112, _e352, (_e352 < _e112));
let _e359 = global_2.member[bitcast<u32>(select(0i, _e354, (_e354 > 0i)))];
let _e360 = local_4;
let _e362 = local_5;
let _e364 = bitcast<i32>(((8u * _e360) + _e362));
let _e366 = select(_e112, _e364, (_e364 < _e112));
let _e371 = global_2.member[bitcast<u32>(select(0i, _e366, (_e366 > 0i)))];
let _e372 = local_4;
let _e374 = local_5;
let _e376 = bitcast<i32>(((9u * _e372) + _e374));
let _e378 = select(_e112, _e376, (_e376 < _e112));
let _e383 = global_2.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e385 = local_4;
let _e387 = local_5;
let _e389 = bitcast<i32>(((10u * _e385) + _e387));
let _e391 = select(_e112, _e389, (_e389 < _e112));
let _e396 = global_2.member[bitcast<u32>(select(0i, _e391, (_e391 > 0i)))];
let _e397 = (_e396 != 0f);
let _e401 = type_15(vec2<f32>(_e279, _e280), vec2<f32>(_e305, _e306), vec2<f32>((_e318 * _e345), (_e330 * _e345)), vec3<f32>(_e359, _e371, _e383), _e397);
if _e80 {
break;
}
local_2 = _e100;
let _e404 = ((_e88 + 1u) * _e93);
local_3 = (_e404 + _e68);
let _e408 = (f32(bitcast<i32>((_e83 + 1u))) - 0.5f);
let _e409 = local_3;
let _e410 = bitcast<i32>(_e409);
let _e412 = select(_e112, _e410, (_e410 < _e112));
let _e417 = global_2.member[bitcast<u32>(select(0i, _e412, (_e412 > 0i)))];
let _e418 = local_2;
let _e419 = local_3;
let _e421 = bitcast<i32>((_e418 + _e419));
let _e423 = select(_e112, _e421, (_e421 < _e112));
let _e428 = global_2.member[bitcast<u32>(select(0i, _e423, (_e423 > 0i)))];
let _e429 = (_e105 + _e417);
let _e430 = (_e408 + _e428);
let _e431 = local_2;
let _e433 = local_3;
let _e435 = bitcast<i32>(((2u * _e431) + _e433));
let _e437 = select(_e112, _e435, (_e435 < _e112));
let _e442 = global_2.member[bitcast<u32>(select(0i, _e437, (_e437 > 0i)))];
let _e443 = local_2;
let _e445 = local_3;
let _e447 = bitcast<i32>(((3u * _e443) + _e445));
let _e449 = select(_e112, _e447, (_e447 < _e112));
let _e454 = global_2.member[bitcast<u32>(select(0i, _e449, (_e449 > 0i)))];
let _e455 = (_e105 + _e442);
let _e456 = (_e408 + _e454);
let _e457 = local_2;
let _e459 = local_3;
let _e461 = bitcast<i32>(((4u * _e457) + _e459));
let _e463 = select(_e112, _e461, (_e461 < _e112));
let _e468 = global_2.member[bitcast<u32>(select(0i, _e463, (_e463 > 0i)))];
let _e469 = local_2;
let _e471 = local_3;
let _e473 = bitcast<i32>(((5u * _e469) + _e471));
let _e475 = select(_e112, _e473, (_e473 < _e112));
let _e480 = global_2.member[bitcast<u32>(select(0i, _e475, (_e475 > 0i)))];
let _e481 = local_2;
let _e483 = local_3;
let _e485 = bitcast<i32>(((6u * _e481) + _e483));
let _e487 = select(_e112, _e485, (_e485 < _e112));
let _e492 = global_2.member[bitcast<u32>(select(0i, _e487, (_e487 > 0i)))];
let _e495 = (1f / select(1e-6f, _e492, (_e492 > 1e-6f)));
let _e498 = local_2;
let _e500 = local_3;
let _e502 = bitcast<i32>(((7u * _e498) + _e500));
let _e504 = select(_e112, _e502, (_e502 < _e112));
let _e509 = global_2.member[bitcast<u32>(select(0i, _e504, (_e504 > 0i)))];
let _e510 = local_2;
let _e512 = local_3;
let _e514 = bitcast<i32>(((8u * _e510) + _e512));
let _e516 = select(_e112, _e514, (_e514 < _e112));
let _e521 = global_2.member[bitcast<u32>(select(0i, _e516, (_e516 > 0i)))];
let _e522 = local_2;
let _e524 = local_3;
let _e526 = bitcast<i32>(((9u * _e522) + _e524));
let _e528 = select(_e112, _e526, (_e526 < _e112));
let _e533 = global_2.member[bitcast<u32>(select(0i, _e528, (_e528 > 0i)))];
let _e535 = local_2;
let _e537 = local_3;
let _e539 = bitcast<i32>(((10u * _e535) + _e537));
let _e541 = select(_e112, _e539, (_e539 < _e112));
let _e546 = global_2.member[bitcast<u32>(select(0i, _e541, (_e541 > 0i)))];
let _e547 = (_e546 != 0f);
let _e551 = type_15(vec2<f32>(_e429, _e430), vec2<f32>(_e455, _e456), vec2<f32>((_e468 * _e495), (_e480 * _e495)), vec3<f32>(_e509, _e521, _e533), _e547);
if _e80 {
break;
}
local = _e100;
local_1 = (_e404 + _e254);
let _e553 = local_1;
let _e554 = bitcast<i32>(_e553);
let _e556 = select(_e112, _e554, (_e554 < _e112));
let _e561 = global_2.member[bitcast<u32>(select(0i, _e556, (_e556 > 0i)))];
let _e562 = local;
let _e563 = local_1;
let _e565 = bitcast<i32>((_e562 + _e563));
let _e567 = select(_e112, _e565, (_e565 < _e112));
let _e572 = global_2.member[bitcast<u32>(select(0i, _e567, (_e567 > 0i)))];
let _e573 = (_e258 + _e561);
let _e574 = (_e408 + _e572);
let _e575 = local;
let _e577 = local_1;
let _e579 = bitcast<i32>(((2u * _e575) + _e577));
let _e581 = select(_e112, _e579, (_e579 < _e112));
let _e586 = global_2.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e587 = local;
let _e589 = local_1;
let _e591 = bitcast<i32>(((3u * _e587) + _e589));
let _e593 = select(_e112, _e591, (_e591 < _e112));
let _e598 = global_2.member[bitcast<u32>(select(0i, _e593, (_e593 > 0i)))];
let _e599 = (_e258 + _e586);
let _e600 = (_e408 + _e598);
let _e601 = local;
let _e603 = local_1;
let _e605 = bitcast<i32>(((4u * _e601) + _e603));
let _e607 = select(_e112, _e605, (_e605 < _e112));
let _e612 = global_2.member[bitcast<u32>(select(0i, _e607, (_e607 > 0i)))];
let _e613 = local;
let _e615 = local_1;
let _e617 = bitcast<i32>(((5u * _e613) + _e615));
let _e619 = select(_e112, _e617, (_e617 < _e112));
let _e624 = global_2.member[bitcast<u32>(select(0i, _e619, (_e619 > 0i)))];
let _e625 = local;
let _e627 = local_1;
let _e629 = bitcast<i32>(((6u * _e625) + _e627));
let _e631 = select(_e112, _e629, (_e629 < _e112));
let _e636 = global_2.member[bitcast<u32>(select(0i, _e631, (_e631 > 0i)))];
let _e639 = (1f / select(1e-6f, _e636, (_e636 > 1e-6f)));
let _e642 = local;
let _e644 = local_1;
let _e646 = bitcast<i32>(((7u * _e642) + _e644));
let _e648 = select(_e112, _e646, (_e646 < _e112));
let _e653 = global_2.member[bitcast<u32>(select(0i, _e648, (_e648 > 0i)))];
let _e654 = local;
let _e656 = local_1;
let _e658 = bitcast<i32>(((8u * _e654) + _e656));
let _e660 = select(_e112, _e658, (_e658 < _e112));
let _e665 = global_2.member[bitcast<u32>(select(0i, _e660, (_e660 > 0i)))];
let _e666 = local;
let _e668 = local_1;
let _e670 = bitcast<i32>(((9u * _e666) + _e668));
let _e672 = select(_e112, _e670, (_e670 < _e112));
let _e677 = global_2.member[bitcast<u32>(select(0i, _e672, (_e672 > 0i)))];
let _e679 = local;
let _e681 = local_1;
let _e683 = bitcast<i32>(((10u * _e679) + _e681));
let _e685 = select(_e112, _e683, (_e683 < _e112));
let _e690 = global_2.member[bitcast<u32>(select(0i, _e685, (_e685 > 0i)))];
let _e691 = (_e690 != 0f);
let _e695 = type_15(vec2<f32>(_e573, _e574), vec2<f32>(_e599, _e600), vec2<f32>((_e612 * _e639), (_e624 * _e639)), vec3<f32>(_e653, _e665, _e677), _e691);
let _e699 = global_1.member.member_9.member_3;
let _e739 = !(((((((((_e131 == _e157) && (_e132 == _e158)) && (_e211 == _e699)) && (_e223 == _e699)) && (_e235 == _e699)) && (((((_e279 == _e305) && (_e280 == _e306)) && (_e359 == _e699)) && (_e371 == _e699)) && (_e383 == _e699))) && (((((_e429 == _e455) && (_e430 == _e456)) && (_e509 == _e699)) && (_e521 == _e699)) && (_e533 == _e699))) && (((((_e573 == _e599) && (_e574 == _e600)) && (_e653 == _e699)) && (_e665 == _e699)) && (_e677 == _e699))));
let _e743 = global_1.member.member_10.member;
let _e747 = global_1.member.member_10.member_1;
let _e751 = global_1.member.member_10.member_2;
let _e754 = (1f / select(1e-6f, _e751, (_e751 > 1e-6f)));
let _e755 = (_e743 * _e754);
let _e756 = (_e747 * _e754);
if _e739 {
if (_e86 == 0u) {
break;
}
let _e768 = bitcast<i32>(((_e88 / _e86) * 3u));
let _e770 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e772 = select(_e770, _e768, (_e768 < _e770));
let _e778 = global_3.member[bitcast<u32>(select(0i, _e772, (_e772 > 0i)))];
let _e779 = (_e768 + 1i);
let _e781 = select(_e770, _e779, (_e779 < _e770));
let _e787 = global_3.member[bitcast<u32>(select(0i, _e781, (_e781 > 0i)))];
let _e788 = (_e768 + 2i);
let _e790 = select(_e770, _e788, (_e788 < _e770));
let _e796 = global_3.member[bitcast<u32>(select(0i, _e790, (_e790 > 0i)))];
let _e797 = -(_e699);
let _e800 = (1f / select(1e-6f, _e796, (_e796 > 1e-6f)));
let _e805 = bitcast<i32>(_e92);
let _e807 = (0.5f * 1f);
let _e808 = (((((_e157 + _e305) + _e455) + _e599) * 0.25f) - _e807);
let _e809 = (((((_e158 + _e306) + _e456) + _e600) * 0.25f) - _e807);
let _e814 = (_e808 + 0.5f);
let _e816 = select(0f, _e814, (_e814 > 0f));
let _e818 = select(65536f, _e816, (_e816 < 65536f));
let _e825 = select(0i, select(select(i32(_e818), i32(-2147483648), (_e818 < -2147483600f)), 2147483647i, (_e818 > 2147483500f)), (_e818 == _e818));
let _e830 = (_e808 + 1f);
let _e831 = (_e830 + 0.5f);
let _e833 = f32((_e805 - 1i));
let _e835 = select(-1f, _e831, (_e831 > -1f));
let _e837 = select(_e833, _e835, (_e835 < _e833));
let _e844 = select(0i, select(select(i32(_e837), i32(-2147483648), (_e837 < -2147483600f)), 2147483647i, (_e837 > 2147483500f)), (_e837 == _e837));
let _e849 = (_e809 + 1f);
let _e850 = (_e849 + 0.5f);
let _e852 = f32((bitcast<i32>(_e79) - 1i));
let _e854 = select(-1f, _e850, (_e850 > -1f));
let _e856 = select(_e852, _e854, (_e854 < _e852));
let _e863 = select(0i, select(select(i32(_e856), i32(-2147483648), (_e856 < -2147483600f)), 2147483647i, (_e856 > 2147483500f)), (_e856 == _e856));
let _e868 = (_e809 + 0.5f);
let _e870 = select(0f, _e868, (_e868 > 0f));
let _e872 = select(65536f, _e870, (_e870 < 65536f));
let _e879 = select(0i, select(select(i32(_e872), i32(-2147483648), (_e872 < -2147483600f)), 2147483647i, (_e872 > 2147483500f)), (_e872 == _e872));
phi_1722_ = (_e879 - select(0i, 1i, (_e872 < f32(_e879))));
loop {
let _e885 = phi_1722_;
let _e886 = (_e885 <= (_e863 - select(0i, 1i, (_e856 < f32(_e863)))));
if _e886 {
let _e887 = f32(_e885);
let _e888 = (_e887 - 0.5f);
let _e891 = (_e887 + 0.5f);
let _e894 = (select(_e891, _e849, (_e849 < _e891)) - select(_e888, _e809, (_e809 > _e888)));
phi_1754_ = (_e825 - select(0i, 1i, (_e818 < f32(_e825))));
loop {
let _e899 = phi_1754_;
let _e900 = (_e899 <= (_e844 - select(0i, 1i, (_e837 < f32(_e844)))));
if _e900 {
let _e901 = f32(_e899);
let _e902 = (_e901 - 0.5f);
let _e905 = (_e901 + 0.5f);
let _e908 = (select(_e905, _e830, (_e830 < _e905)) - select(_e902, _e808, (_e808 > _e902)));
let _e912 = ((select(0f, _e908, (_e908 > 0f)) / 1f) * (select(0f, _e894, (_e894 > 0f)) / 1f));
if (_e912 > 0f) {
let _e916 = (((_e885 * _e805) + _e899) * 10i);
let _e919 = (((_e797 * _e912) * 16777216f) + 0.5f);
let _e921 = select(-1073741800f, _e919, (_e919 > -1073741800f));
let _e923 = select(1073741800f, _e921, (_e921 < 1073741800f));
let _e930 = select(0i, select(select(i32(_e923), i32(-2147483648), (_e923 < -2147483600f)), 2147483647i, (_e923 > 2147483500f)), (_e923 == _e923));
let _e934 = (_e930 - select(0i, 1i, (_e923 < f32(_e930))));
let _e935 = (_e934 == 0i);
if _e935 {
} else {
let _e936 = bitcast<u32>(_e934);
let _e937 = bitcast<u32>(_e916);
if (_e937 < _e62) {
let _e941 = atomicAdd((&global_4.member[_e937]), _e936);
phi_1835_ = _e941;
} else {
phi_1835_ = 0u;
}
let _e943 = phi_1835_;
let _e950 = (bitcast<u32>((_e934 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e943 + _e936) < _e936)));
if (_e950 == 0u) {
} else {
let _e952 = (_e937 + 1u);
if (_e952 < _e62) {
let _e956 = atomicAdd((&global_4.member[_e952]), _e950);
}
}
}
if _e935 {
} else {
let _e958 = bitcast<u32>(_e934);
let _e959 = bitcast<u32>((_e916 + 2i));
if (_e959 < _e62) {
let _e963 = atomicAdd((&global_4.member[_e959]), _e958);
phi_1896_ = _e963;
} else {
phi_1896_ = 0u;
}
let _e965 = phi_1896_;
let _e972 = (bitcast<u32>((_e934 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e965 + _e958) < _e958)));
if (_e972 == 0u) {
} else {
let _e974 = (_e959 + 1u);
if (_e974 < _e62) {
let _e978 = atomicAdd((&global_4.member[_e974]), _e972);
}
}
}
if _e935 {
} else {
let _e980 = bitcast<u32>(_e934);
let _e981 = bitcast<u32>((_e916 + 4i));
if (_e981 < _e62) {
let _e985 = atomicAdd((&global_4.member[_e981]), _e980);
phi_1957_ = _e985;
} else {
phi_1957_ = 0u;
}
let _e987 = phi_1957_;
let _e994 = (bitcast<u32>((_e934 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e987 + _e980) < _e980)));
if (_e994 == 0u) {
} else {
let _e996 = (_e981 + 1u);
if (_e996 < _e62) {
let _e1000 = atomicAdd((&global_4.member[_e996]), _e994);
}
}
}
let _e1002 = ((((_e797 + _e797) + _e797) * (1f / 3f)) * _e912);
let _e1005 = (((_e1002 * ((_e778 * _e800) - _e755)) * 8388608f) + 0.5f);
let _e1007 = select(-1073741800f, _e1005, (_e1005 > -1073741800f));
let _e1009 = select(1073741800f, _e1007, (_e1007 < 1073741800f));
let _e1016 = select(0i, select(select(i32(_e1009), i32(-2147483648), (_e1009 < -2147483600f)), 2147483647i, (_e1009 > 2147483500f)), (_e1009 == _e1009));
let _e1020 = (_e1016 - select(0i, 1i, (_e1009 < f32(_e1016))));
if (_e1020 == 0i) {
} else {
let _e1022 = bitcast<u32>(_e1020);
let _e1023 = bitcast<u32>((_e916 + 6i));
if (_e1023 < _e62) {
let _e1027 = atomicAdd((&global_4.member[_e1023]), _e1022);
phi_2018_ = _e1027;
} else {
phi_2018_ = 0u;
}
let _e1029 = phi_2018_;
let _e1036 = (bitcast<u32>((_e1020 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1029 + _e1022) < _e1022)));
if (_e1036 == 0u) {
} else {
let _e1038 = (_e1023 + 1u);
if (_e1038 < _e62) {
let _e1042 = atomicAdd((&global_4.member[_e1038]), _e1036);
}
}
}
let _e1046 = (((_e1002 * ((_e787 * _e800) - _e756)) * 8388608f) + 0.5f);
let _e1048 = select(-1073741800f, _e1046, (_e1046 > -1073741800f));
let _e1050 = select(1073741800f, _e1048, (_e1048 < 1073741800f));
let _e1057 = select(0i, select(select(i32(_e1050), i32(-2147483648), (_e1050 < -2147483600f)), 2147483647i, (_e1050 > 2147483500f)), (_e1050 == _e1050));
let _e1061 = (_e1057 - select(0i, 1i, (_e1050 < f32(_e1057))));
if (_e1061 == 0i) {
} else {
let _e1063 = bitcast<u32>(_e1061);
let _e1064 = bitcast<u32>((_e916 + 8i));
if (_e1064 < _e62) {
let _e1068 = atomicAdd((&global_4.member[_e1064]), _e1063);
phi_2080_ = _e1068;
} else {
phi_2080_ = 0u;
}
let _e1070 = phi_2080_;
let _e1077 = (bitcast<u32>((_e1061 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1070 + _e1063) < _e1063)));
if (_e1077 == 0u) {
} else {
let _e1079 = (_e1064 + 1u);
if (_e1079 < _e62) {
let _e1083 = atomicAdd((&global_4.member[_e1079]), _e1077);
}
}
}
}
phi_1755_ = (_e899 + 1i);
} else {
phi_1755_ = i32();
}
let _e1086 = phi_1755_;
continue;
continuing {
phi_1754_ = _e1086;
break if !(_e900);
}
}
phi_1723_ = (_e885 + 1i);
} else {
phi_1723_ = i32();
}
let _e1090 = phi_1723_;
continue;
continuing {
phi_1722_ = _e1090;
break if !(_e886);
}
}
}
let _e1102 = (((select(0f, 1f, !(_e249)) + select(0f, 1f, !(_e397))) + select(0f, 1f, !(_e547))) + select(0f, 1f, !(_e691)));
if (_e739 && (_e1102 > 0f)) {
if _e249 {
phi_2132_ = _e551;
} else {
phi_2132_ = _e253;
}
let _e1106 = phi_2132_;
if _e397 {
phi_2136_ = _e695;
} else {
phi_2136_ = _e401;
}
let _e1108 = phi_2136_;
if _e1106.member_4 {
phi_2141_ = _e1108;
} else {
phi_2141_ = _e1106;
}
let _e1111 = phi_2141_;
if _e397 {
phi_2145_ = _e1111;
} else {
phi_2145_ = _e401;
}
let _e1113 = phi_2145_;
if _e249 {
phi_2149_ = _e1113;
} else {
phi_2149_ = _e253;
}
let _e1115 = phi_2149_;
if _e1108.member_4 {
phi_2154_ = _e1106;
} else {
phi_2154_ = _e1108;
}
let _e1118 = phi_2154_;
if _e1115.member_4 {
phi_2159_ = _e1118;
} else {
phi_2159_ = _e1115;
}
let _e1121 = phi_2159_;
if _e397 {
phi_2163_ = _e1121;
} else {
phi_2163_ = _e401;
}
let _e1123 = phi_2163_;
if _e1106.member_4 {
phi_2168_ = _e1108;
} else {
phi_2168_ = _e1106;
}
let _e1125 = phi_2168_;
if _e691 {
phi_2172_ = _e1125;
} else {
phi_2172_ = _e695;
}
let _e1127 = phi_2172_;
if _e547 {
phi_2176_ = _e1127;
} else {
phi_2176_ = _e551;
}
let _e1129 = phi_2176_;
if _e1108.member_4 {
phi_2181_ = _e1106;
} else {
phi_2181_ = _e1108;
}
let _e1131 = phi_2181_;
if _e1129.member_4 {
phi_2186_ = _e1131;
} else {
phi_2186_ = _e1129;
}
let _e1134 = phi_2186_;
if _e691 {
phi_2190_ = _e1134;
} else {
phi_2190_ = _e695;
}
let _e1136 = phi_2190_;
let _e1145 = (_e1123.member.x - _e1115.member.x);
let _e1146 = (_e1123.member.y - _e1115.member.y);
let _e1149 = bitcast<f32>((bitcast<u32>(_e1145) & 2147483647u));
let _e1152 = bitcast<f32>((bitcast<u32>(_e1146) & 2147483647u));
let _e1154 = select(_e1152, _e1149, (_e1149 > _e1152));
let _e1163 = (_e1136.member.x - _e1129.member.x);
let _e1164 = (_e1136.member.y - _e1129.member.y);
let _e1167 = bitcast<f32>((bitcast<u32>(_e1163) & 2147483647u));
let _e1170 = bitcast<f32>((bitcast<u32>(_e1164) & 2147483647u));
let _e1172 = select(_e1170, _e1167, (_e1167 > _e1170));
let _e1175 = (select(_e1172, _e1154, (_e1154 > _e1172)) - 1e-3f);
let _e1176 = (64f - 1f);
let _e1178 = select(0f, _e1175, (_e1175 > 0f));
let _e1180 = select(_e1176, _e1178, (_e1178 < _e1176));
let _e1187 = select(0i, select(select(i32(_e1180), i32(-2147483648), (_e1180 < -2147483600f)), 2147483647i, (_e1180 > 2147483500f)), (_e1180 == _e1180));
let _e1193 = f32((1i + (_e1187 - select(0i, 1i, (_e1180 < f32(_e1187))))));
let _e1194 = (_e1129.member.x - _e1115.member.x);
let _e1195 = (_e1129.member.y - _e1115.member.y);
let _e1198 = bitcast<f32>((bitcast<u32>(_e1194) & 2147483647u));
let _e1201 = bitcast<f32>((bitcast<u32>(_e1195) & 2147483647u));
let _e1203 = select(_e1201, _e1198, (_e1198 > _e1201));
let _e1204 = (_e1136.member.x - _e1123.member.x);
let _e1205 = (_e1136.member.y - _e1123.member.y);
let _e1208 = bitcast<f32>((bitcast<u32>(_e1204) & 2147483647u));
let _e1211 = bitcast<f32>((bitcast<u32>(_e1205) & 2147483647u));
let _e1213 = select(_e1211, _e1208, (_e1208 > _e1211));
let _e1216 = (select(_e1213, _e1203, (_e1203 > _e1213)) - 1e-3f);
let _e1218 = select(0f, _e1216, (_e1216 > 0f));
let _e1220 = select(_e1176, _e1218, (_e1218 < _e1176));
let _e1227 = select(0i, select(select(i32(_e1220), i32(-2147483648), (_e1220 < -2147483600f)), 2147483647i, (_e1220 > 2147483500f)), (_e1220 == _e1220));
let _e1233 = f32((1i + (_e1227 - select(0i, 1i, (_e1220 < f32(_e1227))))));
let _e1235 = (64f / (_e1193 * _e1233));
let _e1237 = select(_e1235, 1f, (1f < _e1235));
let _e1240 = sqrt(select(0f, _e1237, (_e1237 > 0f)));
let _e1241 = (_e1193 * _e1240);
let _e1243 = select(1f, _e1241, (_e1241 > 1f));
let _e1245 = select(64f, _e1243, (_e1243 < 64f));
let _e1252 = select(0i, select(select(i32(_e1245), i32(-2147483648), (_e1245 < -2147483600f)), 2147483647i, (_e1245 > 2147483500f)), (_e1245 == _e1245));
let _e1256 = (_e1252 - select(0i, 1i, (_e1245 < f32(_e1252))));
let _e1257 = (_e1233 * _e1240);
let _e1259 = select(1f, _e1257, (_e1257 > 1f));
let _e1261 = select(64f, _e1259, (_e1259 < 64f));
let _e1268 = select(0i, select(select(i32(_e1261), i32(-2147483648), (_e1261 < -2147483600f)), 2147483647i, (_e1261 > 2147483500f)), (_e1261 == _e1261));
let _e1272 = (_e1268 - select(0i, 1i, (_e1261 < f32(_e1268))));
let _e1274 = (1f / f32(_e1256));
let _e1276 = (1f / f32(_e1272));
let _e1279 = ((_e1274 * _e1276) * (_e1102 * 0.25f));
phi_2392_ = 0i;
loop {
let _e1281 = phi_2392_;
let _e1282 = (_e1281 < _e1272);
if _e1282 {
let _e1285 = ((f32(_e1281) + 0.5f) * _e1276);
phi_2423_ = 0i;
loop {
let _e1293 = phi_2423_;
let _e1294 = (_e1293 < _e1256);
if _e1294 {
let _e1297 = ((f32(_e1293) + 0.5f) * _e1274);
let _e1312 = ((bitcast<f32>((bitcast<u32>((_e1145 + ((_e1163 - _e1145) * _e1285))) & 2147483647u)) * _e1274) + (bitcast<f32>((bitcast<u32>((_e1194 + ((_e1204 - _e1194) * _e1297))) & 2147483647u)) * _e1276));
let _e1321 = ((bitcast<f32>((bitcast<u32>((_e1146 + ((_e1164 - _e1146) * _e1285))) & 2147483647u)) * _e1274) + (bitcast<f32>((bitcast<u32>((_e1195 + ((_e1205 - _e1195) * _e1297))) & 2147483647u)) * _e1276));
let _e1323 = (_e1115.member.x + (_e1145 * _e1297));
let _e1330 = (_e1115.member.y + (_e1146 * _e1297));
let _e1346 = (_e1115.member_3.x + ((_e1123.member_3.x - _e1115.member_3.x) * _e1297));
let _e1353 = ((_e1346 + (((_e1129.member_3.x + ((_e1136.member_3.x - _e1129.member_3.x) * _e1297)) - _e1346) * _e1285)) * _e1279);
let _e1364 = (_e1115.member_3.y + ((_e1123.member_3.y - _e1115.member_3.y) * _e1297));
let _e1371 = ((_e1364 + (((_e1129.member_3.y + ((_e1136.member_3.y - _e1129.member_3.y) * _e1297)) - _e1364) * _e1285)) * _e1279);
let _e1382 = (_e1115.member_3.z + ((_e1123.member_3.z - _e1115.member_3.z) * _e1297));
let _e1389 = ((_e1382 + (((_e1129.member_3.z + ((_e1136.member_3.z - _e1129.member_3.z) * _e1297)) - _e1382) * _e1285)) * _e1279);
let _e1400 = (_e1115.member_2.x + ((_e1123.member_2.x - _e1115.member_2.x) * _e1297));
let _e1417 = (_e1115.member_2.y + ((_e1123.member_2.y - _e1115.member_2.y) * _e1297));
let _e1426 = bitcast<i32>(_e92);
let _e1429 = select(9.765625e-4f, _e1312, (_e1312 > 9.765625e-4f));
let _e1431 = select(4f, _e1429, (_e1429 < 4f));
let _e1433 = select(9.765625e-4f, _e1321, (_e1321 > 9.765625e-4f));
let _e1435 = select(4f, _e1433, (_e1433 < 4f));
let _e1437 = ((_e1323 + (((_e1129.member.x + (_e1163 * _e1297)) - _e1323) * _e1285)) - (0.5f * _e1431));
let _e1439 = ((_e1330 + (((_e1129.member.y + (_e1164 * _e1297)) - _e1330) * _e1285)) - (0.5f * _e1435));
let _e1444 = (_e1437 + 0.5f);
let _e1446 = select(0f, _e1444, (_e1444 > 0f));
let _e1448 = select(65536f, _e1446, (_e1446 < 65536f));
let _e1455 = select(0i, select(select(i32(_e1448), i32(-2147483648), (_e1448 < -2147483600f)), 2147483647i, (_e1448 > 2147483500f)), (_e1448 == _e1448));
let _e1460 = (_e1437 + _e1431);
let _e1461 = (_e1460 + 0.5f);
let _e1463 = f32((_e1426 - 1i));
let _e1465 = select(-1f, _e1461, (_e1461 > -1f));
let _e1467 = select(_e1463, _e1465, (_e1465 < _e1463));
let _e1474 = select(0i, select(select(i32(_e1467), i32(-2147483648), (_e1467 < -2147483600f)), 2147483647i, (_e1467 > 2147483500f)), (_e1467 == _e1467));
let _e1479 = (_e1439 + _e1435);
let _e1480 = (_e1479 + 0.5f);
let _e1482 = f32((bitcast<i32>(_e79) - 1i));
let _e1484 = select(-1f, _e1480, (_e1480 > -1f));
let _e1486 = select(_e1482, _e1484, (_e1484 < _e1482));
let _e1493 = select(0i, select(select(i32(_e1486), i32(-2147483648), (_e1486 < -2147483600f)), 2147483647i, (_e1486 > 2147483500f)), (_e1486 == _e1486));
let _e1498 = (_e1439 + 0.5f);
let _e1500 = select(0f, _e1498, (_e1498 > 0f));
let _e1502 = select(65536f, _e1500, (_e1500 < 65536f));
let _e1509 = select(0i, select(select(i32(_e1502), i32(-2147483648), (_e1502 < -2147483600f)), 2147483647i, (_e1502 > 2147483500f)), (_e1502 == _e1502));
phi_2706_ = (_e1509 - select(0i, 1i, (_e1502 < f32(_e1509))));
loop {
let _e1515 = phi_2706_;
let _e1516 = (_e1515 <= (_e1493 - select(0i, 1i, (_e1486 < f32(_e1493)))));
if _e1516 {
let _e1517 = f32(_e1515);
let _e1518 = (_e1517 - 0.5f);
let _e1521 = (_e1517 + 0.5f);
let _e1524 = (select(_e1521, _e1479, (_e1479 < _e1521)) - select(_e1518, _e1439, (_e1439 > _e1518)));
phi_2738_ = (_e1455 - select(0i, 1i, (_e1448 < f32(_e1455))));
loop {
let _e1529 = phi_2738_;
let _e1530 = (_e1529 <= (_e1474 - select(0i, 1i, (_e1467 < f32(_e1474)))));
if _e1530 {
let _e1531 = f32(_e1529);
let _e1532 = (_e1531 - 0.5f);
let _e1535 = (_e1531 + 0.5f);
let _e1538 = (select(_e1535, _e1460, (_e1460 < _e1535)) - select(_e1532, _e1437, (_e1437 > _e1532)));
let _e1542 = ((select(0f, _e1538, (_e1538 > 0f)) / _e1431) * (select(0f, _e1524, (_e1524 > 0f)) / _e1435));
if (_e1542 > 0f) {
let _e1546 = (((_e1515 * _e1426) + _e1529) * 10i);
let _e1549 = (((_e1353 * _e1542) * 16777216f) + 0.5f);
let _e1551 = select(-1073741800f, _e1549, (_e1549 > -1073741800f));
let _e1553 = select(1073741800f, _e1551, (_e1551 < 1073741800f));
let _e1560 = select(0i, select(select(i32(_e1553), i32(-2147483648), (_e1553 < -2147483600f)), 2147483647i, (_e1553 > 2147483500f)), (_e1553 == _e1553));
let _e1564 = (_e1560 - select(0i, 1i, (_e1553 < f32(_e1560))));
if (_e1564 == 0i) {
} else {
let _e1566 = bitcast<u32>(_e1564);
let _e1567 = bitcast<u32>(_e1546);
if (_e1567 < _e62) {
let _e1571 = atomicAdd((&global_4.member[_e1567]), _e1566);
phi_2819_ = _e1571;
} else {
phi_2819_ = 0u;
}
let _e1573 = phi_2819_;
let _e1580 = (bitcast<u32>((_e1564 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1573 + _e1566) < _e1566)));
if (_e1580 == 0u) {
} else {
let _e1582 = (_e1567 + 1u);
if (_e1582 < _e62) {
let _e1586 = atomicAdd((&global_4.member[_e1582]), _e1580);
}
}
}
let _e1590 = (((_e1371 * _e1542) * 16777216f) + 0.5f);
let _e1592 = select(-1073741800f, _e1590, (_e1590 > -1073741800f));
let _e1594 = select(1073741800f, _e1592, (_e1592 < 1073741800f));
let _e1601 = select(0i, select(select(i32(_e1594), i32(-2147483648), (_e1594 < -2147483600f)), 2147483647i, (_e1594 > 2147483500f)), (_e1594 == _e1594));
let _e1605 = (_e1601 - select(0i, 1i, (_e1594 < f32(_e1601))));
if (_e1605 == 0i) {
} else {
let _e1607 = bitcast<u32>(_e1605);
let _e1608 = bitcast<u32>((_e1546 + 2i));
if (_e1608 < _e62) {
let _e1612 = atomicAdd((&global_4.member[_e1608]), _e1607);
phi_2880_ = _e1612;
} else {
phi_2880_ = 0u;
}
let _e1614 = phi_2880_;
let _e1621 = (bitcast<u32>((_e1605 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1614 + _e1607) < _e1607)));
if (_e1621 == 0u) {
} else {
let _e1623 = (_e1608 + 1u);
if (_e1623 < _e62) {
let _e1627 = atomicAdd((&global_4.member[_e1623]), _e1621);
}
}
}
let _e1631 = (((_e1389 * _e1542) * 16777216f) + 0.5f);
let _e1633 = select(-1073741800f, _e1631, (_e1631 > -1073741800f));
let _e1635 = select(1073741800f, _e1633, (_e1633 < 1073741800f));
let _e1642 = select(0i, select(select(i32(_e1635), i32(-2147483648), (_e1635 < -2147483600f)), 2147483647i, (_e1635 > 2147483500f)), (_e1635 == _e1635));
let _e1646 = (_e1642 - select(0i, 1i, (_e1635 < f32(_e1642))));
if (_e1646 == 0i) {
} else {
let _e1648 = bitcast<u32>(_e1646);
let _e1649 = bitcast<u32>((_e1546 + 4i));
if (_e1649 < _e62) {
let _e1653 = atomicAdd((&global_4.member[_e1649]), _e1648);
phi_2941_ = _e1653;
} else {
phi_2941_ = 0u;
}
let _e1655 = phi_2941_;
let _e1662 = (bitcast<u32>((_e1646 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1655 + _e1648) < _e1648)));
if (_e1662 == 0u) {
} else {
let _e1664 = (_e1649 + 1u);
if (_e1664 < _e62) {
let _e1668 = atomicAdd((&global_4.member[_e1664]), _e1662);
}
}
}
let _e1670 = ((((_e1353 + _e1371) + _e1389) * (1f / 3f)) * _e1542);
let _e1673 = (((_e1670 * ((_e1400 + (((_e1129.member_2.x + ((_e1136.member_2.x - _e1129.member_2.x) * _e1297)) - _e1400) * _e1285)) - _e755)) * 8388608f) + 0.5f);
let _e1675 = select(-1073741800f, _e1673, (_e1673 > -1073741800f));
let _e1677 = select(1073741800f, _e1675, (_e1675 < 1073741800f));
let _e1684 = select(0i, select(select(i32(_e1677), i32(-2147483648), (_e1677 < -2147483600f)), 2147483647i, (_e1677 > 2147483500f)), (_e1677 == _e1677));
let _e1688 = (_e1684 - select(0i, 1i, (_e1677 < f32(_e1684))));
if (_e1688 == 0i) {
} else {
let _e1690 = bitcast<u32>(_e1688);
let _e1691 = bitcast<u32>((_e1546 + 6i));
if (_e1691 < _e62) {
let _e1695 = atomicAdd((&global_4.member[_e1691]), _e1690);
phi_3002_ = _e1695;
} else {
phi_3002_ = 0u;
}
let _e1697 = phi_3002_;
let _e1704 = (bitcast<u32>((_e1688 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1697 + _e1690) < _e1690)));
if (_e1704 == 0u) {
} else {
let _e1706 = (_e1691 + 1u);
if (_e1706 < _e62) {
let _e1710 = atomicAdd((&global_4.member[_e1706]), _e1704);
}
}
}
let _e1714 = (((_e1670 * ((_e1417 + (((_e1129.member_2.y + ((_e1136.member_2.y - _e1129.member_2.y) * _e1297)) - _e1417) * _e1285)) - _e756)) * 8388608f) + 0.5f);
let _e1716 = select(-1073741800f, _e1714, (_e1714 > -1073741800f));
let _e1718 = select(1073741800f, _e1716, (_e1716 < 1073741800f));
let _e1725 = select(0i, select(select(i32(_e1718), i32(-2147483648), (_e1718 < -2147483600f)), 2147483647i, (_e1718 > 2147483500f)), (_e1718 == _e1718));
let _e1729 = (_e1725 - select(0i, 1i, (_e1718 < f32(_e1725))));
if (_e1729 == 0i) {
} else {
let _e1731 = bitcast<u32>(_e1729);
let _e1732 = bitcast<u32>((_e1546 + 8i));
if (_e1732 < _e62) {
let _e1736 = atomicAdd((&global_4.member[_e1732]), _e1731);
phi_3064_ = _e1736;
} else {
phi_3064_ = 0u;
}
let _e1738 = phi_3064_;
let _e1745 = (bitcast<u32>((_e1729 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e1738 + _e1731) < _e1731)));
if (_e1745 == 0u) {
} else {
let _e1747 = (_e1732 + 1u);
if (_e1747 < _e62) {
let _e1751 = atomicAdd((&global_4.member[_e1747]), _e1745);
}
}
}
}
phi_2739_ = (_e1529 + 1i);
} else {
phi_2739_ = i32();
}
let _e1754 = phi_2739_;
continue;
continuing {
phi_2738_ = _e1754;
break if !(_e1530);
}
}
phi_2707_ = (_e1515 + 1i);
} else {
phi_2707_ = i32();
}
let _e1758 = phi_2707_;
continue;
continuing {
phi_2706_ = _e1758;
break if !(_e1516);
}
}
phi_2424_ = (_e1293 + 1i);
} else {
phi_2424_ = i32();
}
let _e1762 = phi_2424_;
continue;
continuing {
phi_2423_ = _e1762;
break if !(_e1294);
}
}
phi_2393_ = (_e1281 + 1i);
} else {
phi_2393_ = i32();
}
let _e1766 = phi_2393_;
continue;
continuing {
phi_2392_ = _e1766;
break if !(_e1282);
}
}
}
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
