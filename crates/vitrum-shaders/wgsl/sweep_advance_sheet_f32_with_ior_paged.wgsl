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
struct type_11 {
member: array<f32>,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_21 {
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
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_18,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: f32,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_23,
member_15: type_23,
member_16: type_23,
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_25 {
member: type_24,
}
struct type_28 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage> global_4: type_16;
@group(0) @binding(5)
var<storage> global_5: type_11;
@group(0) @binding(6)
var<storage, read_write> global_6: type_11;
@group(0) @binding(2)
var<storage> global_7: type_16;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var local_6: type_28;
var local_7: vec3<f32>;
var phi_5473_: type_29;
var phi_6082_: type_30;
var phi_6914_: type_5;
var phi_7938_: f32;
var phi_7939_: f32;
var phi_7940_: f32;
var phi_7941_: bool;
switch bitcast<i32>(0u) {
default: {
let _e90 = global;
let _e93 = arrayLength((&global_2.member));
let _e100 = arrayLength((&global_4.member));
let _e107 = global_1.member.member_2;
let _e110 = global_1.member.member;
let _e118 = (_e90.x + _e107.member);
let _e120 = (_e90.y + _e107.member_1);
if (_e118 < _e107.member_2) {
if (_e120 < _e107.member_3) {
let _e123 = (_e110.member * _e110.member_1);
let _e125 = ((_e120 * _e110.member) + _e118);
let _e126 = bitcast<i32>(_e125);
let _e128 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e130 = select(_e128, _e126, (_e126 < _e128));
let _e136 = global_6.member[bitcast<u32>(select(0i, _e130, (_e130 > 0i)))];
let _e137 = (_e123 + _e125);
let _e138 = bitcast<i32>(_e137);
let _e140 = select(_e128, _e138, (_e138 < _e128));
let _e146 = global_6.member[bitcast<u32>(select(0i, _e140, (_e140 > 0i)))];
let _e148 = ((2u * _e123) + _e125);
let _e149 = bitcast<i32>(_e148);
let _e151 = select(_e128, _e149, (_e149 < _e128));
let _e157 = global_6.member[bitcast<u32>(select(0i, _e151, (_e151 > 0i)))];
let _e159 = ((3u * _e123) + _e125);
let _e160 = bitcast<i32>(_e159);
let _e162 = select(_e128, _e160, (_e160 < _e128));
let _e168 = global_6.member[bitcast<u32>(select(0i, _e162, (_e162 > 0i)))];
let _e170 = ((4u * _e123) + _e125);
let _e171 = bitcast<i32>(_e170);
let _e173 = select(_e128, _e171, (_e171 < _e128));
let _e179 = global_6.member[bitcast<u32>(select(0i, _e173, (_e173 > 0i)))];
let _e181 = ((5u * _e123) + _e125);
let _e182 = bitcast<i32>(_e181);
let _e184 = select(_e128, _e182, (_e182 < _e128));
let _e190 = global_6.member[bitcast<u32>(select(0i, _e184, (_e184 > 0i)))];
let _e192 = ((6u * _e123) + _e125);
let _e193 = bitcast<i32>(_e192);
let _e195 = select(_e128, _e193, (_e193 < _e128));
let _e201 = global_6.member[bitcast<u32>(select(0i, _e195, (_e195 > 0i)))];
let _e203 = ((7u * _e123) + _e125);
let _e204 = bitcast<i32>(_e203);
let _e206 = select(_e128, _e204, (_e204 < _e128));
let _e212 = global_6.member[bitcast<u32>(select(0i, _e206, (_e206 > 0i)))];
let _e214 = ((8u * _e123) + _e125);
let _e215 = bitcast<i32>(_e214);
let _e217 = select(_e128, _e215, (_e215 < _e128));
let _e223 = global_6.member[bitcast<u32>(select(0i, _e217, (_e217 > 0i)))];
let _e225 = ((9u * _e123) + _e125);
let _e226 = bitcast<i32>(_e225);
let _e228 = select(_e128, _e226, (_e226 < _e128));
let _e234 = global_6.member[bitcast<u32>(select(0i, _e228, (_e228 > 0i)))];
let _e236 = ((10u * _e123) + _e125);
let _e237 = bitcast<i32>(_e236);
let _e239 = select(_e128, _e237, (_e237 < _e128));
let _e245 = global_6.member[bitcast<u32>(select(0i, _e239, (_e239 > 0i)))];
let _e249 = global_1.member.member_5.member_2;
let _e252 = (1f / select(1e-6f, _e201, (_e201 > 1e-6f)));
let _e256 = global_1.member.member_8.member_5;
let _e257 = (_e249 * _e256);
let _e262 = global_1.member.member_8.member_6;
let _e264 = (((_e179 * _e252) - _e262) * _e257);
let _e269 = global_1.member.member_8.member_7;
let _e271 = (((_e190 * _e252) - _e269) * _e257);
let _e275 = ((f32(bitcast<i32>(_e118)) - 0.5f) + _e136);
let _e279 = global_1.member.member_8.member_1;
let _e280 = (_e279 + 1u);
let _e282 = select(1u, _e280, (_e280 > 0u));
let _e283 = (_e282 == 0u);
if _e283 {
break;
}
let _e288 = ((f32(bitcast<i32>((_e120 % _e282))) - 0.5f) + _e146);
let _e292 = global_1.member.member_5.member;
let _e296 = global_1.member.member_8.member_8;
let _e297 = (_e292 - _e296);
let _e301 = global_1.member.member_8.member_2;
let _e308 = global_1.member.member_8.member_4;
let _e310 = ((_e301 + (_e262 * _e297)) + ((_e275 + 0.5f) * _e308));
let _e314 = global_1.member.member_8.member_3;
let _e319 = ((_e314 + (_e269 * _e297)) + ((_e288 + 0.5f) * _e308));
let _e325 = global_1.member.member_5.member_1;
let _e326 = (_e325 - _e296);
let _e331 = ((_e301 + (_e262 * _e326)) + (((_e275 + _e264) + 0.5f) * _e308));
let _e336 = ((_e314 + (_e269 * _e326)) + (((_e288 + _e271) + 0.5f) * _e308));
if _e283 {
break;
}
let _e339 = bitcast<i32>(((_e120 / _e282) * 3u));
let _e341 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e343 = select(_e341, _e339, (_e339 < _e341));
let _e349 = global_5.member[bitcast<u32>(select(0i, _e343, (_e343 > 0i)))];
let _e350 = (_e339 + 1i);
let _e352 = select(_e341, _e350, (_e350 < _e341));
let _e358 = global_5.member[bitcast<u32>(select(0i, _e352, (_e352 > 0i)))];
let _e359 = (_e339 + 2i);
let _e361 = select(_e341, _e359, (_e359 < _e341));
let _e367 = global_5.member[bitcast<u32>(select(0i, _e361, (_e361 > 0i)))];
let _e370 = (1f / select(1e-6f, _e367, (_e367 > 1e-6f)));
let _e373 = (((_e349 * _e370) - _e262) * _e257);
let _e376 = (((_e358 * _e370) - _e269) * _e257);
let _e388 = global_1.member.member_6.member;
let _e399 = ((((_e388.member.member * _e310) + (_e388.member.member_1 * _e319)) + (_e388.member.member_2 * _e292)) + _e388.member_1);
let _e403 = global_1.member.member_6.member_1;
let _e414 = ((((_e403.member.member * _e310) + (_e403.member.member_1 * _e319)) + (_e403.member.member_2 * _e292)) + _e403.member_1);
let _e418 = global_1.member.member_6.member_2;
let _e429 = ((((_e418.member.member * _e310) + (_e418.member.member_1 * _e319)) + (_e418.member.member_2 * _e292)) + _e418.member_1);
let _e435 = ((((_e388.member.member * _e331) + (_e388.member.member_1 * _e336)) + (_e388.member.member_2 * _e325)) + _e388.member_1);
let _e441 = ((((_e403.member.member * _e331) + (_e403.member.member_1 * _e336)) + (_e403.member.member_2 * _e325)) + _e403.member_1);
let _e447 = ((((_e418.member.member * _e331) + (_e418.member.member_1 * _e336)) + (_e418.member.member_2 * _e325)) + _e418.member_1);
let _e451 = global_1.member.member_6.member_4;
let _e456 = global_1.member.member_6.member_3.member;
let _e457 = (_e456 - 0.5f);
let _e459 = select(-0.5f, _e435, (_e435 > -0.5f));
let _e461 = select(_e457, _e459, (_e459 < _e457));
let _e466 = global_1.member.member_6.member_3.member_1;
let _e467 = (_e466 - 0.5f);
let _e469 = select(-0.5f, _e441, (_e441 > -0.5f));
let _e471 = select(_e467, _e469, (_e469 < _e467));
let _e476 = global_1.member.member_6.member_3.member_2;
let _e477 = (_e476 - 0.5f);
let _e479 = select(-0.5f, _e447, (_e447 > -0.5f));
let _e481 = select(_e477, _e479, (_e479 < _e477));
let _e482 = (_e435 - _e399);
let _e483 = (_e441 - _e414);
let _e484 = (_e447 - _e429);
let _e487 = bitcast<f32>((bitcast<u32>(_e482) & 2147483647u));
let _e490 = bitcast<f32>((bitcast<u32>(_e483) & 2147483647u));
let _e492 = select(_e490, _e487, (_e487 > _e490));
let _e495 = bitcast<f32>((bitcast<u32>(_e484) & 2147483647u));
let _e504 = bitcast<f32>((bitcast<u32>((_e435 - _e461)) & 2147483647u));
let _e507 = bitcast<f32>((bitcast<u32>((_e441 - _e471)) & 2147483647u));
let _e509 = select(_e507, _e504, (_e504 > _e507));
let _e512 = bitcast<f32>((bitcast<u32>((_e447 - _e481)) & 2147483647u));
let _e516 = (_e461 + 0.5f);
let _e517 = (_e456 - 1f);
let _e519 = select(0f, _e516, (_e516 > 0f));
let _e521 = select(_e517, _e519, (_e519 < _e517));
let _e528 = select(0i, select(select(i32(_e521), i32(-2147483648), (_e521 < -2147483600f)), 2147483647i, (_e521 > 2147483500f)), (_e521 == _e521));
let _e536 = global_1.member.member_6.member_12;
let _e537 = (_e536 & 31u);
let _e540 = (_e471 + 0.5f);
let _e541 = (_e466 - 1f);
let _e543 = select(0f, _e540, (_e540 > 0f));
let _e545 = select(_e541, _e543, (_e543 < _e541));
let _e552 = select(0i, select(select(i32(_e545), i32(-2147483648), (_e545 < -2147483600f)), 2147483647i, (_e545 > 2147483500f)), (_e545 == _e545));
let _e559 = (_e481 + 0.5f);
let _e560 = (_e476 - 1f);
let _e562 = select(0f, _e559, (_e559 > 0f));
let _e564 = select(_e560, _e562, (_e562 < _e560));
let _e571 = select(0i, select(select(i32(_e564), i32(-2147483648), (_e564 < -2147483600f)), 2147483647i, (_e564 > 2147483500f)), (_e564 == _e564));
let _e582 = global_1.member.member_6.member_9.member;
let _e588 = global_1.member.member_6.member_9.member_1;
let _e593 = global_1.member.member_6.member_10;
let _e599 = ((bitcast<i32>(_e593) + ((_e528 - select(0i, 1i, (_e521 < f32(_e528)))) >> bitcast<u32>(_e537))) + (bitcast<i32>(_e582) * (((_e552 - select(0i, 1i, (_e545 < f32(_e552)))) >> bitcast<u32>(_e537)) + (bitcast<i32>(_e588) * ((_e571 - select(0i, 1i, (_e564 < f32(_e571)))) >> bitcast<u32>(_e537))))));
let _e601 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e603 = select(_e601, _e599, (_e599 < _e601));
let _e609 = global_3.member[bitcast<u32>(select(0i, _e603, (_e603 > 0i)))];
let _e616 = global_1.member.member_7.member;
let _e631 = global_1.member.member_7.member_1;
let _e646 = global_1.member.member_7.member_2;
let _e663 = ((((_e616.member.member * _e331) + (_e616.member.member_1 * _e336)) + (_e616.member.member_2 * _e325)) + _e616.member_1);
let _e669 = ((((_e631.member.member * _e331) + (_e631.member.member_1 * _e336)) + (_e631.member.member_2 * _e325)) + _e631.member_1);
let _e675 = ((((_e646.member.member * _e331) + (_e646.member.member_1 * _e336)) + (_e646.member.member_2 * _e325)) + _e646.member_1);
let _e679 = global_1.member.member_7.member_4;
let _e684 = global_1.member.member_7.member_3.member;
let _e685 = (_e684 - 0.5f);
let _e687 = select(-0.5f, _e663, (_e663 > -0.5f));
let _e689 = select(_e685, _e687, (_e687 < _e685));
let _e694 = global_1.member.member_7.member_3.member_1;
let _e695 = (_e694 - 0.5f);
let _e697 = select(-0.5f, _e669, (_e669 > -0.5f));
let _e699 = select(_e695, _e697, (_e697 < _e695));
let _e704 = global_1.member.member_7.member_3.member_2;
let _e705 = (_e704 - 0.5f);
let _e707 = select(-0.5f, _e675, (_e675 > -0.5f));
let _e709 = select(_e705, _e707, (_e707 < _e705));
let _e715 = bitcast<f32>((bitcast<u32>((_e663 - ((((_e616.member.member * _e310) + (_e616.member.member_1 * _e319)) + (_e616.member.member_2 * _e292)) + _e616.member_1))) & 2147483647u));
let _e718 = bitcast<f32>((bitcast<u32>((_e669 - ((((_e631.member.member * _e310) + (_e631.member.member_1 * _e319)) + (_e631.member.member_2 * _e292)) + _e631.member_1))) & 2147483647u));
let _e720 = select(_e718, _e715, (_e715 > _e718));
let _e723 = bitcast<f32>((bitcast<u32>((_e675 - ((((_e646.member.member * _e310) + (_e646.member.member_1 * _e319)) + (_e646.member.member_2 * _e292)) + _e646.member_1))) & 2147483647u));
let _e732 = bitcast<f32>((bitcast<u32>((_e663 - _e689)) & 2147483647u));
let _e735 = bitcast<f32>((bitcast<u32>((_e669 - _e699)) & 2147483647u));
let _e737 = select(_e735, _e732, (_e732 > _e735));
let _e740 = bitcast<f32>((bitcast<u32>((_e675 - _e709)) & 2147483647u));
let _e744 = (_e689 + 0.5f);
let _e745 = (_e684 - 1f);
let _e747 = select(0f, _e744, (_e744 > 0f));
let _e749 = select(_e745, _e747, (_e747 < _e745));
let _e756 = select(0i, select(select(i32(_e749), i32(-2147483648), (_e749 < -2147483600f)), 2147483647i, (_e749 > 2147483500f)), (_e749 == _e749));
let _e764 = global_1.member.member_7.member_12;
let _e765 = (_e764 & 31u);
let _e768 = (_e699 + 0.5f);
let _e769 = (_e694 - 1f);
let _e771 = select(0f, _e768, (_e768 > 0f));
let _e773 = select(_e769, _e771, (_e771 < _e769));
let _e780 = select(0i, select(select(i32(_e773), i32(-2147483648), (_e773 < -2147483600f)), 2147483647i, (_e773 > 2147483500f)), (_e773 == _e773));
let _e787 = (_e709 + 0.5f);
let _e788 = (_e704 - 1f);
let _e790 = select(0f, _e787, (_e787 > 0f));
let _e792 = select(_e788, _e790, (_e790 < _e788));
let _e799 = select(0i, select(select(i32(_e792), i32(-2147483648), (_e792 < -2147483600f)), 2147483647i, (_e792 > 2147483500f)), (_e792 == _e792));
let _e810 = global_1.member.member_7.member_9.member;
let _e816 = global_1.member.member_7.member_9.member_1;
let _e821 = global_1.member.member_7.member_10;
let _e827 = ((bitcast<i32>(_e821) + ((_e756 - select(0i, 1i, (_e749 < f32(_e756)))) >> bitcast<u32>(_e765))) + (bitcast<i32>(_e810) * (((_e780 - select(0i, 1i, (_e773 < f32(_e780)))) >> bitcast<u32>(_e765)) + (bitcast<i32>(_e816) * ((_e799 - select(0i, 1i, (_e792 < f32(_e799)))) >> bitcast<u32>(_e765))))));
let _e829 = select(_e601, _e827, (_e827 < _e601));
let _e835 = global_3.member[bitcast<u32>(select(0i, _e829, (_e829 > 0i)))];
let _e841 = global_1.member.member_1;
let _e848 = (((_e841 & 64u) != 0u) || ((((select(_e495, _e492, (_e492 > _e495)) <= _e451) && ((select(_e512, _e509, (_e509 > _e512)) > _e451) || (_e609 != 0u))) && ((select(_e723, _e720, (_e720 > _e723)) <= _e679) && ((select(_e740, _e737, (_e737 > _e740)) > _e679) || (_e835 != 0u)))) && ((_e841 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e264 == 0f) && (_e271 == 0f)) && (_e373 == 0f)) && (_e376 == 0f))), _e848), (_e245 == 0f)) > 1u) {
if _e283 {
break;
}
if _e283 {
break;
}
let _e855 = (_e110.member_2 == 2u);
let _e858 = (((_e110.member_2 == 1u) || _e855) || (_e110.member_2 == 5u));
if _e858 {
let _e860 = select(-1f, _e461, (_e461 > -1f));
let _e862 = select(_e456, _e860, (_e860 < _e456));
let _e869 = select(0i, select(select(i32(_e862), i32(-2147483648), (_e862 < -2147483600f)), 2147483647i, (_e862 > 2147483500f)), (_e862 == _e862));
let _e873 = (_e869 - select(0i, 1i, (_e862 < f32(_e869))));
let _e875 = select(-1f, _e471, (_e471 > -1f));
let _e877 = select(_e466, _e875, (_e875 < _e466));
let _e884 = select(0i, select(select(i32(_e877), i32(-2147483648), (_e877 < -2147483600f)), 2147483647i, (_e877 > 2147483500f)), (_e877 == _e877));
let _e888 = (_e884 - select(0i, 1i, (_e877 < f32(_e884))));
let _e890 = select(-1f, _e481, (_e481 > -1f));
let _e892 = select(_e476, _e890, (_e890 < _e476));
let _e899 = select(0i, select(select(i32(_e892), i32(-2147483648), (_e892 < -2147483600f)), 2147483647i, (_e892 > 2147483500f)), (_e892 == _e892));
let _e903 = (_e899 - select(0i, 1i, (_e892 < f32(_e899))));
let _e907 = global_1.member.member_6.member_7;
let _e911 = global_1.member.member_6.member_8;
let _e912 = (_e873 + 1i);
let _e913 = (_e888 + 1i);
let _e914 = (_e903 + 1i);
let _e919 = global_1.member.member_6.member_11.member;
let _e925 = global_1.member.member_6.member_11.member_1;
let _e936 = ((_e912 >> bitcast<u32>(4i)) + (bitcast<i32>(_e919) * ((_e913 >> bitcast<u32>(4i)) + (bitcast<i32>(_e925) * (_e914 >> bitcast<u32>(4i))))));
let _e938 = (bitcast<i32>(_e93) - 1i);
let _e940 = select(_e938, _e936, (_e936 < _e938));
let _e946 = global_2.member[bitcast<u32>(select(0i, _e940, (_e940 > 0i)))];
let _e948 = (_e912 & 15i);
let _e951 = ((_e913 & 15i) * _e907);
let _e953 = (bitcast<i32>(_e946) + ((_e914 & 15i) * _e911));
let _e957 = (_e951 + _e907);
let _e959 = (_e951 + (2i * _e907));
let _e960 = (_e953 + _e911);
let _e962 = (_e953 + (2i * _e911));
local_6 = type_28(array<i32, 4>(_e948, (_e948 + 1i), (_e948 + 2i), (_e948 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_7 = vec3<f32>((_e461 - f32(_e873)), (_e471 - f32(_e888)), (_e481 - f32(_e903)));
let _e973 = (_e960 + _e957);
let _e976 = local_6.member[1u];
let _e977 = (_e973 + _e976);
let _e979 = select(_e938, _e977, (_e977 < _e938));
let _e984 = global_2.member[bitcast<u32>(select(0i, _e979, (_e979 > 0i)))];
let _e985 = bitcast<f32>(_e984);
let _e988 = local_6.member[2u];
let _e989 = (_e973 + _e988);
let _e991 = select(_e938, _e989, (_e989 < _e938));
let _e996 = global_2.member[bitcast<u32>(select(0i, _e991, (_e991 > 0i)))];
let _e998 = local_7[0u];
let _e1001 = (_e985 + ((bitcast<f32>(_e996) - _e985) * _e998));
let _e1002 = (_e960 + _e959);
let _e1003 = local_6.member[1u];
let _e1004 = (_e1002 + _e1003);
let _e1006 = select(_e938, _e1004, (_e1004 < _e938));
let _e1011 = global_2.member[bitcast<u32>(select(0i, _e1006, (_e1006 > 0i)))];
let _e1012 = bitcast<f32>(_e1011);
let _e1013 = local_6.member[2u];
let _e1014 = (_e1002 + _e1013);
let _e1016 = select(_e938, _e1014, (_e1014 < _e938));
let _e1021 = global_2.member[bitcast<u32>(select(0i, _e1016, (_e1016 > 0i)))];
let _e1023 = local_7[0u];
let _e1027 = (_e962 + _e957);
let _e1028 = local_6.member[1u];
let _e1029 = (_e1027 + _e1028);
let _e1031 = select(_e938, _e1029, (_e1029 < _e938));
let _e1036 = global_2.member[bitcast<u32>(select(0i, _e1031, (_e1031 > 0i)))];
let _e1037 = bitcast<f32>(_e1036);
let _e1038 = local_6.member[2u];
let _e1039 = (_e1027 + _e1038);
let _e1041 = select(_e938, _e1039, (_e1039 < _e938));
let _e1046 = global_2.member[bitcast<u32>(select(0i, _e1041, (_e1041 > 0i)))];
let _e1048 = local_7[0u];
let _e1051 = (_e1037 + ((bitcast<f32>(_e1046) - _e1037) * _e1048));
let _e1052 = (_e962 + _e959);
let _e1053 = local_6.member[1u];
let _e1054 = (_e1052 + _e1053);
let _e1056 = select(_e938, _e1054, (_e1054 < _e938));
let _e1061 = global_2.member[bitcast<u32>(select(0i, _e1056, (_e1056 > 0i)))];
let _e1062 = bitcast<f32>(_e1061);
let _e1063 = local_6.member[2u];
let _e1064 = (_e1052 + _e1063);
let _e1066 = select(_e938, _e1064, (_e1064 < _e938));
let _e1071 = global_2.member[bitcast<u32>(select(0i, _e1066, (_e1066 > 0i)))];
let _e1073 = local_7[0u];
let _e1078 = local_7[1u];
let _e1081 = (_e1001 + (((_e1012 + ((bitcast<f32>(_e1021) - _e1012) * _e1023)) - _e1001) * _e1078));
let _e1082 = local_7[1u];
let _e1087 = local_7[2u];
let _e1094 = global_1.member.member_6.member_5;
let _e1099 = global_1.member.member_6.member_6;
let _e1100 = (((_e1081 + (((_e1051 + (((_e1062 + ((bitcast<f32>(_e1071) - _e1062) * _e1073)) - _e1051) * _e1082)) - _e1081) * _e1087)) * _e1094) + _e1099);
let _e1102 = select(0f, _e1100, (_e1100 > 0f));
let _e1106 = select(-1f, _e689, (_e689 > -1f));
let _e1108 = select(_e684, _e1106, (_e1106 < _e684));
let _e1115 = select(0i, select(select(i32(_e1108), i32(-2147483648), (_e1108 < -2147483600f)), 2147483647i, (_e1108 > 2147483500f)), (_e1108 == _e1108));
let _e1119 = (_e1115 - select(0i, 1i, (_e1108 < f32(_e1115))));
let _e1121 = select(-1f, _e699, (_e699 > -1f));
let _e1123 = select(_e694, _e1121, (_e1121 < _e694));
let _e1130 = select(0i, select(select(i32(_e1123), i32(-2147483648), (_e1123 < -2147483600f)), 2147483647i, (_e1123 > 2147483500f)), (_e1123 == _e1123));
let _e1134 = (_e1130 - select(0i, 1i, (_e1123 < f32(_e1130))));
let _e1136 = select(-1f, _e709, (_e709 > -1f));
let _e1138 = select(_e704, _e1136, (_e1136 < _e704));
let _e1145 = select(0i, select(select(i32(_e1138), i32(-2147483648), (_e1138 < -2147483600f)), 2147483647i, (_e1138 > 2147483500f)), (_e1138 == _e1138));
let _e1149 = (_e1145 - select(0i, 1i, (_e1138 < f32(_e1145))));
let _e1153 = global_1.member.member_7.member_7;
let _e1157 = global_1.member.member_7.member_8;
let _e1158 = (_e1119 + 1i);
let _e1159 = (_e1134 + 1i);
let _e1160 = (_e1149 + 1i);
let _e1165 = global_1.member.member_7.member_11.member;
let _e1171 = global_1.member.member_7.member_11.member_1;
let _e1182 = ((_e1158 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1165) * ((_e1159 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1171) * (_e1160 >> bitcast<u32>(4i))))));
let _e1184 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1186 = select(_e1184, _e1182, (_e1182 < _e1184));
let _e1192 = global_7.member[bitcast<u32>(select(0i, _e1186, (_e1186 > 0i)))];
let _e1194 = (_e1158 & 15i);
let _e1197 = ((_e1159 & 15i) * _e1153);
let _e1199 = (bitcast<i32>(_e1192) + ((_e1160 & 15i) * _e1157));
let _e1203 = (_e1197 + _e1153);
let _e1205 = (_e1197 + (2i * _e1153));
let _e1207 = (_e1197 + (3i * _e1153));
let _e1208 = (_e1199 + _e1157);
let _e1210 = (_e1199 + (2i * _e1157));
let _e1212 = (_e1199 + (3i * _e1157));
local_4 = type_28(array<i32, 4>(_e1194, (_e1194 + 1i), (_e1194 + 2i), (_e1194 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e689 - f32(_e1119)), (_e699 - f32(_e1134)), (_e709 - f32(_e1149)));
let _e1223 = (_e1208 + _e1203);
let _e1226 = local_4.member[0u];
let _e1227 = (_e1223 + _e1226);
let _e1229 = select(_e1184, _e1227, (_e1227 < _e1184));
let _e1234 = global_7.member[bitcast<u32>(select(0i, _e1229, (_e1229 > 0i)))];
let _e1235 = bitcast<f32>(_e1234);
let _e1238 = local_4.member[1u];
let _e1239 = (_e1223 + _e1238);
let _e1241 = select(_e1184, _e1239, (_e1239 < _e1184));
let _e1246 = global_7.member[bitcast<u32>(select(0i, _e1241, (_e1241 > 0i)))];
let _e1247 = bitcast<f32>(_e1246);
let _e1250 = local_4.member[2u];
let _e1251 = (_e1223 + _e1250);
let _e1253 = select(_e1184, _e1251, (_e1251 < _e1184));
let _e1258 = global_7.member[bitcast<u32>(select(0i, _e1253, (_e1253 > 0i)))];
let _e1259 = bitcast<f32>(_e1258);
let _e1262 = local_4.member[3u];
let _e1263 = (_e1223 + _e1262);
let _e1265 = select(_e1184, _e1263, (_e1263 < _e1184));
let _e1270 = global_7.member[bitcast<u32>(select(0i, _e1265, (_e1265 > 0i)))];
let _e1272 = local_5[0u];
let _e1275 = (_e1235 + ((_e1247 - _e1235) * _e1272));
let _e1276 = local_5[0u];
let _e1279 = (_e1247 + ((_e1259 - _e1247) * _e1276));
let _e1280 = local_5[0u];
let _e1283 = (_e1259 + ((bitcast<f32>(_e1270) - _e1259) * _e1280));
let _e1284 = (_e1208 + _e1205);
let _e1285 = local_4.member[0u];
let _e1286 = (_e1284 + _e1285);
let _e1288 = select(_e1184, _e1286, (_e1286 < _e1184));
let _e1293 = global_7.member[bitcast<u32>(select(0i, _e1288, (_e1288 > 0i)))];
let _e1294 = bitcast<f32>(_e1293);
let _e1295 = local_4.member[1u];
let _e1296 = (_e1284 + _e1295);
let _e1298 = select(_e1184, _e1296, (_e1296 < _e1184));
let _e1303 = global_7.member[bitcast<u32>(select(0i, _e1298, (_e1298 > 0i)))];
let _e1304 = bitcast<f32>(_e1303);
let _e1305 = local_4.member[2u];
let _e1306 = (_e1284 + _e1305);
let _e1308 = select(_e1184, _e1306, (_e1306 < _e1184));
let _e1313 = global_7.member[bitcast<u32>(select(0i, _e1308, (_e1308 > 0i)))];
let _e1314 = bitcast<f32>(_e1313);
let _e1315 = local_4.member[3u];
let _e1316 = (_e1284 + _e1315);
let _e1318 = select(_e1184, _e1316, (_e1316 < _e1184));
let _e1323 = global_7.member[bitcast<u32>(select(0i, _e1318, (_e1318 > 0i)))];
let _e1325 = local_5[0u];
let _e1329 = local_5[0u];
let _e1332 = (_e1304 + ((_e1314 - _e1304) * _e1329));
let _e1333 = local_5[0u];
let _e1337 = (_e1210 + _e1203);
let _e1338 = local_4.member[0u];
let _e1339 = (_e1337 + _e1338);
let _e1341 = select(_e1184, _e1339, (_e1339 < _e1184));
let _e1346 = global_7.member[bitcast<u32>(select(0i, _e1341, (_e1341 > 0i)))];
let _e1347 = bitcast<f32>(_e1346);
let _e1348 = local_4.member[1u];
let _e1349 = (_e1337 + _e1348);
let _e1351 = select(_e1184, _e1349, (_e1349 < _e1184));
let _e1356 = global_7.member[bitcast<u32>(select(0i, _e1351, (_e1351 > 0i)))];
let _e1357 = bitcast<f32>(_e1356);
let _e1358 = local_4.member[2u];
let _e1359 = (_e1337 + _e1358);
let _e1361 = select(_e1184, _e1359, (_e1359 < _e1184));
let _e1366 = global_7.member[bitcast<u32>(select(0i, _e1361, (_e1361 > 0i)))];
let _e1367 = bitcast<f32>(_e1366);
let _e1368 = local_4.member[3u];
let _e1369 = (_e1337 + _e1368);
let _e1371 = select(_e1184, _e1369, (_e1369 < _e1184));
let _e1376 = global_7.member[bitcast<u32>(select(0i, _e1371, (_e1371 > 0i)))];
let _e1378 = local_5[0u];
let _e1381 = (_e1347 + ((_e1357 - _e1347) * _e1378));
let _e1382 = local_5[0u];
let _e1385 = (_e1357 + ((_e1367 - _e1357) * _e1382));
let _e1386 = local_5[0u];
let _e1389 = (_e1367 + ((bitcast<f32>(_e1376) - _e1367) * _e1386));
let _e1390 = (_e1210 + _e1205);
let _e1391 = local_4.member[0u];
let _e1392 = (_e1390 + _e1391);
let _e1394 = select(_e1184, _e1392, (_e1392 < _e1184));
let _e1399 = global_7.member[bitcast<u32>(select(0i, _e1394, (_e1394 > 0i)))];
let _e1400 = bitcast<f32>(_e1399);
let _e1401 = local_4.member[1u];
let _e1402 = (_e1390 + _e1401);
let _e1404 = select(_e1184, _e1402, (_e1402 < _e1184));
let _e1409 = global_7.member[bitcast<u32>(select(0i, _e1404, (_e1404 > 0i)))];
let _e1410 = bitcast<f32>(_e1409);
let _e1411 = local_4.member[2u];
let _e1412 = (_e1390 + _e1411);
let _e1414 = select(_e1184, _e1412, (_e1412 < _e1184));
let _e1419 = global_7.member[bitcast<u32>(select(0i, _e1414, (_e1414 > 0i)))];
let _e1420 = bitcast<f32>(_e1419);
let _e1421 = local_4.member[3u];
let _e1422 = (_e1390 + _e1421);
let _e1424 = select(_e1184, _e1422, (_e1422 < _e1184));
let _e1429 = global_7.member[bitcast<u32>(select(0i, _e1424, (_e1424 > 0i)))];
let _e1431 = local_5[0u];
let _e1435 = local_5[0u];
let _e1438 = (_e1410 + ((_e1420 - _e1410) * _e1435));
let _e1439 = local_5[0u];
let _e1443 = (_e1208 + _e1197);
let _e1444 = local_4.member[1u];
let _e1445 = (_e1443 + _e1444);
let _e1447 = select(_e1184, _e1445, (_e1445 < _e1184));
let _e1452 = global_7.member[bitcast<u32>(select(0i, _e1447, (_e1447 > 0i)))];
let _e1453 = bitcast<f32>(_e1452);
let _e1454 = local_4.member[2u];
let _e1455 = (_e1443 + _e1454);
let _e1457 = select(_e1184, _e1455, (_e1455 < _e1184));
let _e1462 = global_7.member[bitcast<u32>(select(0i, _e1457, (_e1457 > 0i)))];
let _e1464 = local_5[0u];
let _e1467 = (_e1453 + ((bitcast<f32>(_e1462) - _e1453) * _e1464));
let _e1468 = (_e1208 + _e1207);
let _e1469 = local_4.member[1u];
let _e1470 = (_e1468 + _e1469);
let _e1472 = select(_e1184, _e1470, (_e1470 < _e1184));
let _e1477 = global_7.member[bitcast<u32>(select(0i, _e1472, (_e1472 > 0i)))];
let _e1478 = bitcast<f32>(_e1477);
let _e1479 = local_4.member[2u];
let _e1480 = (_e1468 + _e1479);
let _e1482 = select(_e1184, _e1480, (_e1480 < _e1184));
let _e1487 = global_7.member[bitcast<u32>(select(0i, _e1482, (_e1482 > 0i)))];
let _e1489 = local_5[0u];
let _e1493 = (_e1210 + _e1197);
let _e1494 = local_4.member[1u];
let _e1495 = (_e1493 + _e1494);
let _e1497 = select(_e1184, _e1495, (_e1495 < _e1184));
let _e1502 = global_7.member[bitcast<u32>(select(0i, _e1497, (_e1497 > 0i)))];
let _e1503 = bitcast<f32>(_e1502);
let _e1504 = local_4.member[2u];
let _e1505 = (_e1493 + _e1504);
let _e1507 = select(_e1184, _e1505, (_e1505 < _e1184));
let _e1512 = global_7.member[bitcast<u32>(select(0i, _e1507, (_e1507 > 0i)))];
let _e1514 = local_5[0u];
let _e1517 = (_e1503 + ((bitcast<f32>(_e1512) - _e1503) * _e1514));
let _e1518 = (_e1210 + _e1207);
let _e1519 = local_4.member[1u];
let _e1520 = (_e1518 + _e1519);
let _e1522 = select(_e1184, _e1520, (_e1520 < _e1184));
let _e1527 = global_7.member[bitcast<u32>(select(0i, _e1522, (_e1522 > 0i)))];
let _e1528 = bitcast<f32>(_e1527);
let _e1529 = local_4.member[2u];
let _e1530 = (_e1518 + _e1529);
let _e1532 = select(_e1184, _e1530, (_e1530 < _e1184));
let _e1537 = global_7.member[bitcast<u32>(select(0i, _e1532, (_e1532 > 0i)))];
let _e1539 = local_5[0u];
let _e1543 = (_e1199 + _e1203);
let _e1544 = local_4.member[1u];
let _e1545 = (_e1543 + _e1544);
let _e1547 = select(_e1184, _e1545, (_e1545 < _e1184));
let _e1552 = global_7.member[bitcast<u32>(select(0i, _e1547, (_e1547 > 0i)))];
let _e1553 = bitcast<f32>(_e1552);
let _e1554 = local_4.member[2u];
let _e1555 = (_e1543 + _e1554);
let _e1557 = select(_e1184, _e1555, (_e1555 < _e1184));
let _e1562 = global_7.member[bitcast<u32>(select(0i, _e1557, (_e1557 > 0i)))];
let _e1564 = local_5[0u];
let _e1567 = (_e1553 + ((bitcast<f32>(_e1562) - _e1553) * _e1564));
let _e1568 = (_e1212 + _e1203);
let _e1569 = local_4.member[1u];
let _e1570 = (_e1568 + _e1569);
let _e1572 = select(_e1184, _e1570, (_e1570 < _e1184));
let _e1577 = global_7.member[bitcast<u32>(select(0i, _e1572, (_e1572 > 0i)))];
let _e1578 = bitcast<f32>(_e1577);
let _e1579 = local_4.member[2u];
let _e1580 = (_e1568 + _e1579);
let _e1582 = select(_e1184, _e1580, (_e1580 < _e1184));
let _e1587 = global_7.member[bitcast<u32>(select(0i, _e1582, (_e1582 > 0i)))];
let _e1589 = local_5[0u];
let _e1592 = (_e1578 + ((bitcast<f32>(_e1587) - _e1578) * _e1589));
let _e1593 = (_e1199 + _e1205);
let _e1594 = local_4.member[1u];
let _e1595 = (_e1593 + _e1594);
let _e1597 = select(_e1184, _e1595, (_e1595 < _e1184));
let _e1602 = global_7.member[bitcast<u32>(select(0i, _e1597, (_e1597 > 0i)))];
let _e1603 = bitcast<f32>(_e1602);
let _e1604 = local_4.member[2u];
let _e1605 = (_e1593 + _e1604);
let _e1607 = select(_e1184, _e1605, (_e1605 < _e1184));
let _e1612 = global_7.member[bitcast<u32>(select(0i, _e1607, (_e1607 > 0i)))];
let _e1614 = local_5[0u];
let _e1618 = (_e1212 + _e1205);
let _e1619 = local_4.member[1u];
let _e1620 = (_e1618 + _e1619);
let _e1622 = select(_e1184, _e1620, (_e1620 < _e1184));
let _e1627 = global_7.member[bitcast<u32>(select(0i, _e1622, (_e1622 > 0i)))];
let _e1628 = bitcast<f32>(_e1627);
let _e1629 = local_4.member[2u];
let _e1630 = (_e1618 + _e1629);
let _e1632 = select(_e1184, _e1630, (_e1630 < _e1184));
let _e1637 = global_7.member[bitcast<u32>(select(0i, _e1632, (_e1632 > 0i)))];
let _e1639 = local_5[0u];
let _e1644 = local_5[1u];
let _e1647 = (_e1279 + ((_e1332 - _e1279) * _e1644));
let _e1648 = local_5[1u];
let _e1651 = (_e1385 + ((_e1438 - _e1385) * _e1648));
let _e1652 = local_5[1u];
let _e1655 = (_e1275 + (((_e1294 + ((_e1304 - _e1294) * _e1325)) - _e1275) * _e1652));
let _e1656 = local_5[1u];
let _e1661 = local_5[2u];
let _e1665 = local_5[1u];
let _e1668 = (_e1283 + (((_e1314 + ((bitcast<f32>(_e1323) - _e1314) * _e1333)) - _e1283) * _e1665));
let _e1669 = local_5[1u];
let _e1673 = local_5[2u];
let _e1677 = local_5[1u];
let _e1680 = (_e1467 + ((_e1279 - _e1467) * _e1677));
let _e1681 = local_5[1u];
let _e1685 = local_5[2u];
let _e1689 = local_5[1u];
let _e1692 = (_e1332 + (((_e1478 + ((bitcast<f32>(_e1487) - _e1478) * _e1489)) - _e1332) * _e1689));
let _e1693 = local_5[1u];
let _e1697 = local_5[2u];
let _e1701 = local_5[1u];
let _e1704 = (_e1567 + (((_e1603 + ((bitcast<f32>(_e1612) - _e1603) * _e1614)) - _e1567) * _e1701));
let _e1705 = local_5[2u];
let _e1709 = local_5[1u];
let _e1713 = local_5[2u];
let _e1717 = local_5[2u];
let _e1724 = global_1.member.member_7.member_5;
let _e1729 = global_1.member.member_7.member_6;
let _e1730 = (((_e1647 + ((_e1651 - _e1647) * _e1717)) * _e1724) + _e1729);
let _e1732 = select(0f, _e1730, (_e1730 > 0f));
let _e1736 = (((_e1655 + (((_e1381 + (((_e1400 + ((_e1410 - _e1400) * _e1431)) - _e1381) * _e1656)) - _e1655) * _e1661)) * _e1724) + _e1729);
let _e1738 = select(0f, _e1736, (_e1736 > 0f));
let _e1740 = select(1f, _e1738, (_e1738 < 1f));
let _e1742 = (((_e1668 + (((_e1389 + (((_e1420 + ((bitcast<f32>(_e1429) - _e1420) * _e1439)) - _e1389) * _e1669)) - _e1668) * _e1673)) * _e1724) + _e1729);
let _e1744 = select(0f, _e1742, (_e1742 > 0f));
let _e1746 = select(1f, _e1744, (_e1744 < 1f));
let _e1748 = (((_e1680 + (((_e1517 + ((_e1385 - _e1517) * _e1681)) - _e1680) * _e1685)) * _e1724) + _e1729);
let _e1750 = select(0f, _e1748, (_e1748 > 0f));
let _e1752 = select(1f, _e1750, (_e1750 < 1f));
let _e1754 = (((_e1692 + (((_e1438 + (((_e1528 + ((bitcast<f32>(_e1537) - _e1528) * _e1539)) - _e1438) * _e1693)) - _e1692) * _e1697)) * _e1724) + _e1729);
let _e1756 = select(0f, _e1754, (_e1754 > 0f));
let _e1758 = select(1f, _e1756, (_e1756 < 1f));
let _e1760 = (((_e1704 + ((_e1647 - _e1704) * _e1705)) * _e1724) + _e1729);
let _e1762 = select(0f, _e1760, (_e1760 > 0f));
let _e1764 = select(1f, _e1762, (_e1762 < 1f));
let _e1766 = (((_e1651 + (((_e1592 + (((_e1628 + ((bitcast<f32>(_e1637) - _e1628) * _e1639)) - _e1592) * _e1709)) - _e1651) * _e1713)) * _e1724) + _e1729);
let _e1768 = select(0f, _e1766, (_e1766 > 0f));
let _e1770 = select(1f, _e1768, (_e1768 < 1f));
let _e1771 = (select(1f, _e1732, (_e1732 < 1f)) * 1024f);
let _e1772 = (1024f - 1f);
let _e1774 = select(0f, _e1771, (_e1771 > 0f));
let _e1776 = select(_e1772, _e1774, (_e1774 < _e1772));
let _e1783 = select(0i, select(select(i32(_e1776), i32(-2147483648), (_e1776 < -2147483600f)), 2147483647i, (_e1776 > 2147483500f)), (_e1776 == _e1776));
let _e1787 = (_e1783 - select(0i, 1i, (_e1776 < f32(_e1783))));
let _e1788 = (262147i + _e1787);
let _e1790 = (bitcast<i32>(_e100) - 1i);
let _e1792 = select(_e1790, _e1788, (_e1788 < _e1790));
let _e1798 = global_4.member[bitcast<u32>(select(0i, _e1792, (_e1792 > 0i)))];
let _e1808 = select(_e1790, 262146i, (262146i < _e1790));
let _e1814 = global_4.member[bitcast<u32>(select(0i, _e1808, (_e1808 > 0i)))];
let _e1815 = bitcast<f32>(_e1814);
let _e1816 = (f32((bitcast<i32>((_e1798 & 4095u)) - 2048i)) * _e1815);
let _e1818 = select(_e1790, 262144i, (262144i < _e1790));
let _e1824 = global_4.member[bitcast<u32>(select(0i, _e1818, (_e1818 > 0i)))];
let _e1825 = bitcast<f32>(_e1824);
let _e1827 = select(_e1790, 262145i, (262145i < _e1790));
let _e1833 = global_4.member[bitcast<u32>(select(0i, _e1827, (_e1827 > 0i)))];
let _e1834 = bitcast<f32>(_e1833);
let _e1840 = ((_e1825 + (f32(bitcast<i32>((_e1798 >> bitcast<u32>(12u)))) * _e1834)) + (_e1816 * (_e1771 - f32(_e1787))));
let _e1841 = (_e1816 * 1024f);
if _e855 {
let _e1848 = ((0.5f * (_e1746 - _e1740)) * _e1841);
let _e1849 = ((0.5f * (_e1758 - _e1752)) * _e1841);
let _e1850 = ((0.5f * (_e1770 - _e1764)) * _e1841);
phi_5473_ = type_29(_e1840, vec3<f32>(_e1848, _e1849, _e1850), vec3<f32>((_e1848 * _e1840), (_e1849 * _e1840), (_e1850 * _e1840)));
} else {
let _e1857 = (_e1740 * 1024f);
let _e1859 = select(0f, _e1857, (_e1857 > 0f));
let _e1861 = select(_e1772, _e1859, (_e1859 < _e1772));
let _e1868 = select(0i, select(select(i32(_e1861), i32(-2147483648), (_e1861 < -2147483600f)), 2147483647i, (_e1861 > 2147483500f)), (_e1861 == _e1861));
let _e1872 = (_e1868 - select(0i, 1i, (_e1861 < f32(_e1868))));
let _e1873 = (262147i + _e1872);
let _e1875 = select(_e1790, _e1873, (_e1873 < _e1790));
let _e1881 = global_4.member[bitcast<u32>(select(0i, _e1875, (_e1875 > 0i)))];
let _e1896 = ((_e1825 + (f32(bitcast<i32>((_e1881 >> bitcast<u32>(12u)))) * _e1834)) + ((f32((bitcast<i32>((_e1881 & 4095u)) - 2048i)) * _e1815) * (_e1857 - f32(_e1872))));
let _e1897 = (_e1746 * 1024f);
let _e1899 = select(0f, _e1897, (_e1897 > 0f));
let _e1901 = select(_e1772, _e1899, (_e1899 < _e1772));
let _e1908 = select(0i, select(select(i32(_e1901), i32(-2147483648), (_e1901 < -2147483600f)), 2147483647i, (_e1901 > 2147483500f)), (_e1901 == _e1901));
let _e1912 = (_e1908 - select(0i, 1i, (_e1901 < f32(_e1908))));
let _e1913 = (262147i + _e1912);
let _e1915 = select(_e1790, _e1913, (_e1913 < _e1790));
let _e1921 = global_4.member[bitcast<u32>(select(0i, _e1915, (_e1915 > 0i)))];
let _e1936 = ((_e1825 + (f32(bitcast<i32>((_e1921 >> bitcast<u32>(12u)))) * _e1834)) + ((f32((bitcast<i32>((_e1921 & 4095u)) - 2048i)) * _e1815) * (_e1897 - f32(_e1912))));
let _e1937 = (_e1752 * 1024f);
let _e1939 = select(0f, _e1937, (_e1937 > 0f));
let _e1941 = select(_e1772, _e1939, (_e1939 < _e1772));
let _e1948 = select(0i, select(select(i32(_e1941), i32(-2147483648), (_e1941 < -2147483600f)), 2147483647i, (_e1941 > 2147483500f)), (_e1941 == _e1941));
let _e1952 = (_e1948 - select(0i, 1i, (_e1941 < f32(_e1948))));
let _e1953 = (262147i + _e1952);
let _e1955 = select(_e1790, _e1953, (_e1953 < _e1790));
let _e1961 = global_4.member[bitcast<u32>(select(0i, _e1955, (_e1955 > 0i)))];
let _e1976 = ((_e1825 + (f32(bitcast<i32>((_e1961 >> bitcast<u32>(12u)))) * _e1834)) + ((f32((bitcast<i32>((_e1961 & 4095u)) - 2048i)) * _e1815) * (_e1937 - f32(_e1952))));
let _e1977 = (_e1758 * 1024f);
let _e1979 = select(0f, _e1977, (_e1977 > 0f));
let _e1981 = select(_e1772, _e1979, (_e1979 < _e1772));
let _e1988 = select(0i, select(select(i32(_e1981), i32(-2147483648), (_e1981 < -2147483600f)), 2147483647i, (_e1981 > 2147483500f)), (_e1981 == _e1981));
let _e1992 = (_e1988 - select(0i, 1i, (_e1981 < f32(_e1988))));
let _e1993 = (262147i + _e1992);
let _e1995 = select(_e1790, _e1993, (_e1993 < _e1790));
let _e2001 = global_4.member[bitcast<u32>(select(0i, _e1995, (_e1995 > 0i)))];
let _e2016 = ((_e1825 + (f32(bitcast<i32>((_e2001 >> bitcast<u32>(12u)))) * _e1834)) + ((f32((bitcast<i32>((_e2001 & 4095u)) - 2048i)) * _e1815) * (_e1977 - f32(_e1992))));
let _e2017 = (_e1764 * 1024f);
let _e2019 = select(0f, _e2017, (_e2017 > 0f));
let _e2021 = select(_e1772, _e2019, (_e2019 < _e1772));
let _e2028 = select(0i, select(select(i32(_e2021), i32(-2147483648), (_e2021 < -2147483600f)), 2147483647i, (_e2021 > 2147483500f)), (_e2021 == _e2021));
let _e2032 = (_e2028 - select(0i, 1i, (_e2021 < f32(_e2028))));
let _e2033 = (262147i + _e2032);
let _e2035 = select(_e1790, _e2033, (_e2033 < _e1790));
let _e2041 = global_4.member[bitcast<u32>(select(0i, _e2035, (_e2035 > 0i)))];
let _e2056 = ((_e1825 + (f32(bitcast<i32>((_e2041 >> bitcast<u32>(12u)))) * _e1834)) + ((f32((bitcast<i32>((_e2041 & 4095u)) - 2048i)) * _e1815) * (_e2017 - f32(_e2032))));
let _e2057 = (_e1770 * 1024f);
let _e2059 = select(0f, _e2057, (_e2057 > 0f));
let _e2061 = select(_e1772, _e2059, (_e2059 < _e1772));
let _e2068 = select(0i, select(select(i32(_e2061), i32(-2147483648), (_e2061 < -2147483600f)), 2147483647i, (_e2061 > 2147483500f)), (_e2061 == _e2061));
let _e2072 = (_e2068 - select(0i, 1i, (_e2061 < f32(_e2068))));
let _e2073 = (262147i + _e2072);
let _e2075 = select(_e1790, _e2073, (_e2073 < _e1790));
let _e2081 = global_4.member[bitcast<u32>(select(0i, _e2075, (_e2075 > 0i)))];
let _e2096 = ((_e1825 + (f32(bitcast<i32>((_e2081 >> bitcast<u32>(12u)))) * _e1834)) + ((f32((bitcast<i32>((_e2081 & 4095u)) - 2048i)) * _e1815) * (_e2057 - f32(_e2072))));
let _e2097 = (_e1936 - _e1896);
let _e2099 = (_e2016 - _e1976);
let _e2101 = (_e2096 - _e2056);
phi_5473_ = type_29(_e1840, vec3<f32>((0.5f * _e2097), (0.5f * _e2099), (0.5f * _e2101)), vec3<f32>((0.25f * (_e2097 * (_e1936 + _e1896))), (0.25f * (_e2099 * (_e2016 + _e1976))), (0.25f * (_e2101 * (_e2096 + _e2056)))));
}
let _e2116 = phi_5473_;
let _e2131 = select(0f, 1f, ((((((_e663 >= -0.5f) && (_e663 <= _e685)) && (_e669 >= -0.5f)) && (_e669 <= _e695)) && (_e675 >= -0.5f)) && (_e675 <= _e705)));
let _e2133 = (0.5f * (_e1746 - _e1740));
let _e2135 = (0.5f * (_e1758 - _e1752));
let _e2137 = (0.5f * (_e1770 - _e1764));
let _e2143 = global_1.member.member_7.member.member.member;
let _e2149 = global_1.member.member_7.member.member.member_1;
let _e2155 = global_1.member.member_7.member.member.member_2;
let _e2161 = global_1.member.member_7.member_1.member.member;
let _e2167 = global_1.member.member_7.member_1.member.member_1;
let _e2173 = global_1.member.member_7.member_1.member.member_2;
let _e2179 = global_1.member.member_7.member_2.member.member;
let _e2185 = global_1.member.member_7.member_2.member.member_1;
let _e2191 = global_1.member.member_7.member_2.member.member_2;
phi_6082_ = type_30(select(1f, _e1102, (_e1102 < 1f)), vec3<f32>(((((_e2143 * _e2133) + (_e2161 * _e2135)) + (_e2179 * _e2137)) * _e2131), ((((_e2149 * _e2133) + (_e2167 * _e2135)) + (_e2185 * _e2137)) * _e2131), ((((_e2155 * _e2133) + (_e2173 * _e2135)) + (_e2191 * _e2137)) * _e2131)), _e2116.member, vec3<f32>(((((_e2143 * _e2116.member_2.x) + (_e2161 * _e2116.member_2.y)) + (_e2179 * _e2116.member_2.z)) * _e2131), ((((_e2149 * _e2116.member_2.x) + (_e2167 * _e2116.member_2.y)) + (_e2185 * _e2116.member_2.z)) * _e2131), ((((_e2155 * _e2116.member_2.x) + (_e2173 * _e2116.member_2.y)) + (_e2191 * _e2116.member_2.z)) * _e2131)), vec3<f32>(((((_e2143 * _e2116.member_1.x) + (_e2161 * _e2116.member_1.y)) + (_e2179 * _e2116.member_1.z)) * _e2131), ((((_e2149 * _e2116.member_1.x) + (_e2167 * _e2116.member_1.y)) + (_e2185 * _e2116.member_1.z)) * _e2131), ((((_e2155 * _e2116.member_1.x) + (_e2173 * _e2116.member_1.y)) + (_e2191 * _e2116.member_1.z)) * _e2131)));
} else {
let _e2257 = select(-1f, _e461, (_e461 > -1f));
let _e2259 = select(_e456, _e2257, (_e2257 < _e456));
let _e2266 = select(0i, select(select(i32(_e2259), i32(-2147483648), (_e2259 < -2147483600f)), 2147483647i, (_e2259 > 2147483500f)), (_e2259 == _e2259));
let _e2270 = (_e2266 - select(0i, 1i, (_e2259 < f32(_e2266))));
let _e2272 = select(-1f, _e471, (_e471 > -1f));
let _e2274 = select(_e466, _e2272, (_e2272 < _e466));
let _e2281 = select(0i, select(select(i32(_e2274), i32(-2147483648), (_e2274 < -2147483600f)), 2147483647i, (_e2274 > 2147483500f)), (_e2274 == _e2274));
let _e2285 = (_e2281 - select(0i, 1i, (_e2274 < f32(_e2281))));
let _e2287 = select(-1f, _e481, (_e481 > -1f));
let _e2289 = select(_e476, _e2287, (_e2287 < _e476));
let _e2296 = select(0i, select(select(i32(_e2289), i32(-2147483648), (_e2289 < -2147483600f)), 2147483647i, (_e2289 > 2147483500f)), (_e2289 == _e2289));
let _e2300 = (_e2296 - select(0i, 1i, (_e2289 < f32(_e2296))));
let _e2304 = global_1.member.member_6.member_7;
let _e2308 = global_1.member.member_6.member_8;
let _e2309 = (_e2270 + 1i);
let _e2310 = (_e2285 + 1i);
let _e2311 = (_e2300 + 1i);
let _e2316 = global_1.member.member_6.member_11.member;
let _e2322 = global_1.member.member_6.member_11.member_1;
let _e2333 = ((_e2309 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2316) * ((_e2310 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2322) * (_e2311 >> bitcast<u32>(4i))))));
let _e2335 = (bitcast<i32>(_e93) - 1i);
let _e2337 = select(_e2335, _e2333, (_e2333 < _e2335));
let _e2343 = global_2.member[bitcast<u32>(select(0i, _e2337, (_e2337 > 0i)))];
let _e2345 = (_e2309 & 15i);
let _e2348 = ((_e2310 & 15i) * _e2304);
let _e2350 = (bitcast<i32>(_e2343) + ((_e2311 & 15i) * _e2308));
let _e2354 = (_e2348 + _e2304);
let _e2356 = (_e2348 + (2i * _e2304));
let _e2357 = (_e2350 + _e2308);
let _e2359 = (_e2350 + (2i * _e2308));
local_2 = type_28(array<i32, 4>(_e2345, (_e2345 + 1i), (_e2345 + 2i), (_e2345 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e461 - f32(_e2270)), (_e471 - f32(_e2285)), (_e481 - f32(_e2300)));
let _e2370 = (_e2357 + _e2354);
let _e2373 = local_2.member[1u];
let _e2374 = (_e2370 + _e2373);
let _e2376 = select(_e2335, _e2374, (_e2374 < _e2335));
let _e2381 = global_2.member[bitcast<u32>(select(0i, _e2376, (_e2376 > 0i)))];
let _e2382 = bitcast<f32>(_e2381);
let _e2385 = local_2.member[2u];
let _e2386 = (_e2370 + _e2385);
let _e2388 = select(_e2335, _e2386, (_e2386 < _e2335));
let _e2393 = global_2.member[bitcast<u32>(select(0i, _e2388, (_e2388 > 0i)))];
let _e2395 = local_3[0u];
let _e2398 = (_e2382 + ((bitcast<f32>(_e2393) - _e2382) * _e2395));
let _e2399 = (_e2357 + _e2356);
let _e2400 = local_2.member[1u];
let _e2401 = (_e2399 + _e2400);
let _e2403 = select(_e2335, _e2401, (_e2401 < _e2335));
let _e2408 = global_2.member[bitcast<u32>(select(0i, _e2403, (_e2403 > 0i)))];
let _e2409 = bitcast<f32>(_e2408);
let _e2410 = local_2.member[2u];
let _e2411 = (_e2399 + _e2410);
let _e2413 = select(_e2335, _e2411, (_e2411 < _e2335));
let _e2418 = global_2.member[bitcast<u32>(select(0i, _e2413, (_e2413 > 0i)))];
let _e2420 = local_3[0u];
let _e2425 = local_3[1u];
let _e2428 = (_e2398 + (((_e2409 + ((bitcast<f32>(_e2418) - _e2409) * _e2420)) - _e2398) * _e2425));
let _e2429 = (_e2359 + _e2354);
let _e2430 = local_2.member[1u];
let _e2431 = (_e2429 + _e2430);
let _e2433 = select(_e2335, _e2431, (_e2431 < _e2335));
let _e2438 = global_2.member[bitcast<u32>(select(0i, _e2433, (_e2433 > 0i)))];
let _e2439 = bitcast<f32>(_e2438);
let _e2440 = local_2.member[2u];
let _e2441 = (_e2429 + _e2440);
let _e2443 = select(_e2335, _e2441, (_e2441 < _e2335));
let _e2448 = global_2.member[bitcast<u32>(select(0i, _e2443, (_e2443 > 0i)))];
let _e2450 = local_3[0u];
let _e2453 = (_e2439 + ((bitcast<f32>(_e2448) - _e2439) * _e2450));
let _e2454 = (_e2359 + _e2356);
let _e2455 = local_2.member[1u];
let _e2456 = (_e2454 + _e2455);
let _e2458 = select(_e2335, _e2456, (_e2456 < _e2335));
let _e2463 = global_2.member[bitcast<u32>(select(0i, _e2458, (_e2458 > 0i)))];
let _e2464 = bitcast<f32>(_e2463);
let _e2465 = local_2.member[2u];
let _e2466 = (_e2454 + _e2465);
let _e2468 = select(_e2335, _e2466, (_e2466 < _e2335));
let _e2473 = global_2.member[bitcast<u32>(select(0i, _e2468, (_e2468 > 0i)))];
let _e2475 = local_3[0u];
let _e2479 = local_3[1u];
let _e2484 = local_3[2u];
let _e2491 = global_1.member.member_6.member_5;
let _e2496 = global_1.member.member_6.member_6;
let _e2497 = (((_e2428 + (((_e2453 + (((_e2464 + ((bitcast<f32>(_e2473) - _e2464) * _e2475)) - _e2453) * _e2479)) - _e2428) * _e2484)) * _e2491) + _e2496);
let _e2499 = select(0f, _e2497, (_e2497 > 0f));
phi_6082_ = type_30(select(1f, _e2499, (_e2499 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2504 = phi_6082_;
let _e2506 = select(-0.5f, _e399, (_e399 > -0.5f));
let _e2508 = select(_e457, _e2506, (_e2506 < _e457));
let _e2510 = select(-0.5f, _e414, (_e414 > -0.5f));
let _e2512 = select(_e467, _e2510, (_e2510 < _e467));
let _e2514 = select(-0.5f, _e429, (_e429 > -0.5f));
let _e2516 = select(_e477, _e2514, (_e2514 < _e477));
let _e2518 = select(-1f, _e2508, (_e2508 > -1f));
let _e2520 = select(_e456, _e2518, (_e2518 < _e456));
let _e2527 = select(0i, select(select(i32(_e2520), i32(-2147483648), (_e2520 < -2147483600f)), 2147483647i, (_e2520 > 2147483500f)), (_e2520 == _e2520));
let _e2531 = (_e2527 - select(0i, 1i, (_e2520 < f32(_e2527))));
let _e2533 = select(-1f, _e2512, (_e2512 > -1f));
let _e2535 = select(_e466, _e2533, (_e2533 < _e466));
let _e2542 = select(0i, select(select(i32(_e2535), i32(-2147483648), (_e2535 < -2147483600f)), 2147483647i, (_e2535 > 2147483500f)), (_e2535 == _e2535));
let _e2546 = (_e2542 - select(0i, 1i, (_e2535 < f32(_e2542))));
let _e2548 = select(-1f, _e2516, (_e2516 > -1f));
let _e2550 = select(_e476, _e2548, (_e2548 < _e476));
let _e2557 = select(0i, select(select(i32(_e2550), i32(-2147483648), (_e2550 < -2147483600f)), 2147483647i, (_e2550 > 2147483500f)), (_e2550 == _e2550));
let _e2561 = (_e2557 - select(0i, 1i, (_e2550 < f32(_e2557))));
let _e2565 = global_1.member.member_6.member_7;
let _e2569 = global_1.member.member_6.member_8;
let _e2570 = (_e2531 + 1i);
let _e2571 = (_e2546 + 1i);
let _e2572 = (_e2561 + 1i);
let _e2577 = global_1.member.member_6.member_11.member;
let _e2583 = global_1.member.member_6.member_11.member_1;
let _e2594 = ((_e2570 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2577) * ((_e2571 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2583) * (_e2572 >> bitcast<u32>(4i))))));
let _e2596 = (bitcast<i32>(_e93) - 1i);
let _e2598 = select(_e2596, _e2594, (_e2594 < _e2596));
let _e2604 = global_2.member[bitcast<u32>(select(0i, _e2598, (_e2598 > 0i)))];
let _e2606 = (_e2570 & 15i);
let _e2609 = ((_e2571 & 15i) * _e2565);
let _e2611 = (bitcast<i32>(_e2604) + ((_e2572 & 15i) * _e2569));
let _e2615 = (_e2609 + _e2565);
let _e2617 = (_e2609 + (2i * _e2565));
let _e2618 = (_e2611 + _e2569);
let _e2620 = (_e2611 + (2i * _e2569));
local = type_28(array<i32, 4>(_e2606, (_e2606 + 1i), (_e2606 + 2i), (_e2606 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2508 - f32(_e2531)), (_e2512 - f32(_e2546)), (_e2516 - f32(_e2561)));
let _e2631 = (_e2618 + _e2615);
let _e2634 = local.member[1u];
let _e2635 = (_e2631 + _e2634);
let _e2637 = select(_e2596, _e2635, (_e2635 < _e2596));
let _e2642 = global_2.member[bitcast<u32>(select(0i, _e2637, (_e2637 > 0i)))];
let _e2643 = bitcast<f32>(_e2642);
let _e2646 = local.member[2u];
let _e2647 = (_e2631 + _e2646);
let _e2649 = select(_e2596, _e2647, (_e2647 < _e2596));
let _e2654 = global_2.member[bitcast<u32>(select(0i, _e2649, (_e2649 > 0i)))];
let _e2656 = local_1[0u];
let _e2659 = (_e2643 + ((bitcast<f32>(_e2654) - _e2643) * _e2656));
let _e2660 = (_e2618 + _e2617);
let _e2661 = local.member[1u];
let _e2662 = (_e2660 + _e2661);
let _e2664 = select(_e2596, _e2662, (_e2662 < _e2596));
let _e2669 = global_2.member[bitcast<u32>(select(0i, _e2664, (_e2664 > 0i)))];
let _e2670 = bitcast<f32>(_e2669);
let _e2671 = local.member[2u];
let _e2672 = (_e2660 + _e2671);
let _e2674 = select(_e2596, _e2672, (_e2672 < _e2596));
let _e2679 = global_2.member[bitcast<u32>(select(0i, _e2674, (_e2674 > 0i)))];
let _e2681 = local_1[0u];
let _e2686 = local_1[1u];
let _e2689 = (_e2659 + (((_e2670 + ((bitcast<f32>(_e2679) - _e2670) * _e2681)) - _e2659) * _e2686));
let _e2690 = (_e2620 + _e2615);
let _e2691 = local.member[1u];
let _e2692 = (_e2690 + _e2691);
let _e2694 = select(_e2596, _e2692, (_e2692 < _e2596));
let _e2699 = global_2.member[bitcast<u32>(select(0i, _e2694, (_e2694 > 0i)))];
let _e2700 = bitcast<f32>(_e2699);
let _e2701 = local.member[2u];
let _e2702 = (_e2690 + _e2701);
let _e2704 = select(_e2596, _e2702, (_e2702 < _e2596));
let _e2709 = global_2.member[bitcast<u32>(select(0i, _e2704, (_e2704 > 0i)))];
let _e2711 = local_1[0u];
let _e2714 = (_e2700 + ((bitcast<f32>(_e2709) - _e2700) * _e2711));
let _e2715 = (_e2620 + _e2617);
let _e2716 = local.member[1u];
let _e2717 = (_e2715 + _e2716);
let _e2719 = select(_e2596, _e2717, (_e2717 < _e2596));
let _e2724 = global_2.member[bitcast<u32>(select(0i, _e2719, (_e2719 > 0i)))];
let _e2725 = bitcast<f32>(_e2724);
let _e2726 = local.member[2u];
let _e2727 = (_e2715 + _e2726);
let _e2729 = select(_e2596, _e2727, (_e2727 < _e2596));
let _e2734 = global_2.member[bitcast<u32>(select(0i, _e2729, (_e2729 > 0i)))];
let _e2736 = local_1[0u];
let _e2740 = local_1[1u];
let _e2745 = local_1[2u];
let _e2752 = global_1.member.member_6.member_5;
let _e2757 = global_1.member.member_6.member_6;
let _e2758 = (((_e2689 + (((_e2714 + (((_e2725 + ((bitcast<f32>(_e2734) - _e2725) * _e2736)) - _e2714) * _e2740)) - _e2689) * _e2745)) * _e2752) + _e2757);
let _e2760 = select(0f, _e2758, (_e2758 > 0f));
if ((_e841 & 16u) == 0u) {
phi_6914_ = type_5(1f, 1f, 1f);
} else {
let _e2768 = global_1.member.member_14.member;
let _e2779 = ((((_e2768.member.member * _e310) + (_e2768.member.member_1 * _e319)) + (_e2768.member.member_2 * _e292)) + _e2768.member_1);
let _e2785 = ((((_e2768.member.member * _e331) + (_e2768.member.member_1 * _e336)) + (_e2768.member.member_2 * _e325)) + _e2768.member_1);
let _e2787 = select(_e2785, _e2779, (_e2779 < _e2785));
let _e2789 = select(_e2785, _e2779, (_e2779 > _e2785));
let _e2791 = (_e2789 - _e2787);
let _e2794 = (-(_e2787) / select(1e-30f, _e2791, (_e2791 > 1e-30f)));
let _e2796 = select(0f, _e2794, (_e2794 > 0f));
let _e2802 = select(select(select(1f, _e2796, (_e2796 < 1f)), 1f, (_e2789 <= 0f)), 0f, (_e2787 > 0f));
let _e2807 = global_1.member.member_14.member_1;
let _e2808 = (_e2807 != 0u);
let _e2818 = global_1.member.member_15.member;
let _e2829 = ((((_e2818.member.member * _e310) + (_e2818.member.member_1 * _e319)) + (_e2818.member.member_2 * _e292)) + _e2818.member_1);
let _e2835 = ((((_e2818.member.member * _e331) + (_e2818.member.member_1 * _e336)) + (_e2818.member.member_2 * _e325)) + _e2818.member_1);
let _e2837 = select(_e2835, _e2829, (_e2829 < _e2835));
let _e2839 = select(_e2835, _e2829, (_e2829 > _e2835));
let _e2841 = (_e2839 - _e2837);
let _e2844 = (-(_e2837) / select(1e-30f, _e2841, (_e2841 > 1e-30f)));
let _e2846 = select(0f, _e2844, (_e2844 > 0f));
let _e2852 = select(select(select(1f, _e2846, (_e2846 < 1f)), 1f, (_e2839 <= 0f)), 0f, (_e2837 > 0f));
let _e2857 = global_1.member.member_15.member_1;
let _e2858 = (_e2857 != 0u);
let _e2868 = global_1.member.member_16.member;
let _e2879 = ((((_e2868.member.member * _e310) + (_e2868.member.member_1 * _e319)) + (_e2868.member.member_2 * _e292)) + _e2868.member_1);
let _e2885 = ((((_e2868.member.member * _e331) + (_e2868.member.member_1 * _e336)) + (_e2868.member.member_2 * _e325)) + _e2868.member_1);
let _e2887 = select(_e2885, _e2879, (_e2879 < _e2885));
let _e2889 = select(_e2885, _e2879, (_e2879 > _e2885));
let _e2891 = (_e2889 - _e2887);
let _e2894 = (-(_e2887) / select(1e-30f, _e2891, (_e2891 > 1e-30f)));
let _e2896 = select(0f, _e2894, (_e2894 > 0f));
let _e2902 = select(select(select(1f, _e2896, (_e2896 < 1f)), 1f, (_e2889 <= 0f)), 0f, (_e2887 > 0f));
let _e2907 = global_1.member.member_16.member_1;
let _e2908 = (_e2907 != 0u);
let _e2918 = global_1.member.member_17.member;
let _e2929 = ((((_e2918.member.member * _e310) + (_e2918.member.member_1 * _e319)) + (_e2918.member.member_2 * _e292)) + _e2918.member_1);
let _e2935 = ((((_e2918.member.member * _e331) + (_e2918.member.member_1 * _e336)) + (_e2918.member.member_2 * _e325)) + _e2918.member_1);
let _e2937 = select(_e2935, _e2929, (_e2929 < _e2935));
let _e2939 = select(_e2935, _e2929, (_e2929 > _e2935));
let _e2941 = (_e2939 - _e2937);
let _e2944 = (-(_e2937) / select(1e-30f, _e2941, (_e2941 > 1e-30f)));
let _e2946 = select(0f, _e2944, (_e2944 > 0f));
let _e2952 = select(select(select(1f, _e2946, (_e2946 < 1f)), 1f, (_e2939 <= 0f)), 0f, (_e2937 > 0f));
let _e2957 = global_1.member.member_17.member_1;
let _e2958 = (_e2957 != 0u);
phi_6914_ = type_5(((((1f * _e2802) * _e2852) * _e2902) * _e2952), ((((1f * select(1f, _e2802, _e2808)) * select(1f, _e2852, _e2858)) * select(1f, _e2902, _e2908)) * select(1f, _e2952, _e2958)), ((((1f * select(1f, 0f, (_e2808 && (_e2785 > 0f)))) * select(1f, 0f, (_e2858 && (_e2835 > 0f)))) * select(1f, 0f, (_e2908 && (_e2885 > 0f)))) * select(1f, 0f, (_e2958 && (_e2935 > 0f)))));
}
let _e2967 = phi_6914_;
let _e2968 = (_e331 - _e310);
let _e2969 = (_e336 - _e319);
let _e2970 = (_e325 - _e292);
let _e2975 = (((_e2968 * _e2968) + (_e2969 * _e2969)) + (_e2970 * _e2970));
let _e2979 = (_e487 < 1e-12f);
let _e2981 = (1f / select(_e482, 1f, _e2979));
let _e2983 = ((-0.5f - _e399) * _e2981);
let _e2985 = ((_e457 - _e399) * _e2981);
let _e2991 = select(_e2985, _e2983, (_e2983 < _e2985));
let _e2993 = select(0f, _e2991, (_e2991 > 0f));
let _e2996 = select(select(1f, _e2993, (_e2993 < 1f)), select(2f, 0f, ((_e399 >= -0.5f) && (_e399 <= _e457))), _e2979);
let _e2998 = select(_e2985, _e2983, (_e2983 > _e2985));
let _e3000 = select(0f, _e2998, (_e2998 > 0f));
let _e3003 = select(select(1f, _e3000, (_e3000 < 1f)), 1f, _e2979);
let _e3004 = (_e490 < 1e-12f);
let _e3006 = (1f / select(_e483, 1f, _e3004));
let _e3008 = ((-0.5f - _e414) * _e3006);
let _e3010 = ((_e467 - _e414) * _e3006);
let _e3016 = select(_e3010, _e3008, (_e3008 < _e3010));
let _e3018 = select(0f, _e3016, (_e3016 > 0f));
let _e3021 = select(select(1f, _e3018, (_e3018 < 1f)), select(2f, 0f, ((_e414 >= -0.5f) && (_e414 <= _e467))), _e3004);
let _e3023 = select(_e3010, _e3008, (_e3008 > _e3010));
let _e3025 = select(0f, _e3023, (_e3023 > 0f));
let _e3028 = select(select(1f, _e3025, (_e3025 < 1f)), 1f, _e3004);
let _e3029 = (_e495 < 1e-12f);
let _e3031 = (1f / select(_e484, 1f, _e3029));
let _e3033 = ((-0.5f - _e429) * _e3031);
let _e3035 = ((_e477 - _e429) * _e3031);
let _e3041 = select(_e3035, _e3033, (_e3033 < _e3035));
let _e3043 = select(0f, _e3041, (_e3041 > 0f));
let _e3046 = select(select(1f, _e3043, (_e3043 < 1f)), select(2f, 0f, ((_e429 >= -0.5f) && (_e429 <= _e477))), _e3029);
let _e3048 = select(_e3035, _e3033, (_e3033 > _e3035));
let _e3050 = select(0f, _e3048, (_e3048 > 0f));
let _e3053 = select(select(1f, _e3050, (_e3050 < 1f)), 1f, _e3029);
let _e3055 = select(_e3028, _e3003, (_e3003 < _e3028));
let _e3059 = select(_e3021, _e2996, (_e2996 > _e3021));
let _e3062 = (select(_e3053, _e3055, (_e3055 < _e3053)) - select(_e3046, _e3059, (_e3059 > _e3046)));
let _e3069 = global_1.member.member_5.member_3;
let _e3070 = ((sqrt(select(0f, _e2975, (_e2975 > 0f))) * select(0f, _e3062, (_e3062 > 0f))) * _e3069);
let _e3072 = (select(1f, _e2760, (_e2760 < 1f)) * 255f);
let _e3073 = (_e2504.member * 255f);
let _e3074 = (255f - 1f);
let _e3076 = select(0f, _e3072, (_e3072 > 0f));
let _e3078 = select(_e3074, _e3076, (_e3076 < _e3074));
let _e3085 = select(0i, select(select(i32(_e3078), i32(-2147483648), (_e3078 < -2147483600f)), 2147483647i, (_e3078 > 2147483500f)), (_e3078 == _e3078));
let _e3089 = (_e3085 - select(0i, 1i, (_e3078 < f32(_e3085))));
let _e3091 = select(0f, _e3073, (_e3073 > 0f));
let _e3093 = select(_e3074, _e3091, (_e3091 < _e3074));
let _e3100 = select(0i, select(select(i32(_e3093), i32(-2147483648), (_e3093 < -2147483600f)), 2147483647i, (_e3093 > 2147483500f)), (_e3093 == _e3093));
let _e3104 = (_e3100 - select(0i, 1i, (_e3093 < f32(_e3100))));
let _e3107 = (((_e3089 * 256i) + _e3104) * 4i);
let _e3109 = (_e3072 - f32(_e3089));
let _e3111 = (_e3073 - f32(_e3104));
let _e3113 = (bitcast<i32>(_e100) - 1i);
let _e3115 = select(_e3113, _e3107, (_e3107 < _e3113));
let _e3121 = global_4.member[bitcast<u32>(select(0i, _e3115, (_e3115 > 0i)))];
let _e3122 = (_e3107 + 4i);
let _e3124 = select(_e3113, _e3122, (_e3122 < _e3113));
let _e3130 = global_4.member[bitcast<u32>(select(0i, _e3124, (_e3124 > 0i)))];
let _e3131 = (_e3107 + 1024i);
let _e3133 = select(_e3113, _e3131, (_e3131 < _e3113));
let _e3139 = global_4.member[bitcast<u32>(select(0i, _e3133, (_e3133 > 0i)))];
let _e3140 = (_e3107 + 1028i);
let _e3142 = select(_e3113, _e3140, (_e3140 < _e3113));
let _e3148 = global_4.member[bitcast<u32>(select(0i, _e3142, (_e3142 > 0i)))];
let _e3153 = (bitcast<f32>(((_e3121 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3161 = (_e3153 + (((bitcast<f32>(((_e3130 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3153) * _e3111));
let _e3166 = (bitcast<f32>(((_e3139 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3190 = (bitcast<f32>((((_e3121 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3198 = (_e3190 + (((bitcast<f32>((((_e3130 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3190) * _e3111));
let _e3203 = (bitcast<f32>((((_e3139 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3215 = (_e3107 + 1i);
let _e3217 = select(_e3113, _e3215, (_e3215 < _e3113));
let _e3223 = global_4.member[bitcast<u32>(select(0i, _e3217, (_e3217 > 0i)))];
let _e3224 = (_e3107 + 5i);
let _e3226 = select(_e3113, _e3224, (_e3224 < _e3113));
let _e3232 = global_4.member[bitcast<u32>(select(0i, _e3226, (_e3226 > 0i)))];
let _e3233 = (_e3107 + 1025i);
let _e3235 = select(_e3113, _e3233, (_e3233 < _e3113));
let _e3241 = global_4.member[bitcast<u32>(select(0i, _e3235, (_e3235 > 0i)))];
let _e3242 = (_e3107 + 1029i);
let _e3244 = select(_e3113, _e3242, (_e3242 < _e3113));
let _e3250 = global_4.member[bitcast<u32>(select(0i, _e3244, (_e3244 > 0i)))];
let _e3255 = (bitcast<f32>(((_e3223 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3263 = (_e3255 + (((bitcast<f32>(((_e3232 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3255) * _e3111));
let _e3268 = (bitcast<f32>(((_e3241 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3292 = (bitcast<f32>((((_e3223 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3300 = (_e3292 + (((bitcast<f32>((((_e3232 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3292) * _e3111));
let _e3305 = (bitcast<f32>((((_e3241 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3320 = (_e3070 * _e2967.member_1);
let _e3322 = -(((_e3198 + (((_e3203 + (((bitcast<f32>((((_e3148 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3203) * _e3111)) - _e3198) * _e3109)) * _e3320));
let _e3324 = select(-87f, _e3322, (_e3322 > -87f));
let _e3326 = select(88f, _e3324, (_e3324 < 88f));
let _e3328 = ((_e3326 * 1.442695f) + 0.5f);
let _e3330 = select(-127f, _e3328, (_e3328 > -127f));
let _e3332 = select(128f, _e3330, (_e3330 < 128f));
let _e3339 = select(0i, select(select(i32(_e3332), i32(-2147483648), (_e3332 < -2147483600f)), 2147483647i, (_e3332 > 2147483500f)), (_e3332 == _e3332));
let _e3343 = (_e3339 - select(0i, 1i, (_e3332 < f32(_e3339))));
let _e3344 = f32(_e3343);
let _e3348 = ((_e3326 - (_e3344 * 0.6933594f)) - (_e3344 * -2.1219444e-4f));
let _e3370 = -(((_e3263 + (((_e3268 + (((bitcast<f32>(((_e3250 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3268) * _e3111)) - _e3263) * _e3109)) * _e3320));
let _e3372 = select(-87f, _e3370, (_e3370 > -87f));
let _e3374 = select(88f, _e3372, (_e3372 < 88f));
let _e3376 = ((_e3374 * 1.442695f) + 0.5f);
let _e3378 = select(-127f, _e3376, (_e3376 > -127f));
let _e3380 = select(128f, _e3378, (_e3378 < 128f));
let _e3387 = select(0i, select(select(i32(_e3380), i32(-2147483648), (_e3380 < -2147483600f)), 2147483647i, (_e3380 > 2147483500f)), (_e3380 == _e3380));
let _e3391 = (_e3387 - select(0i, 1i, (_e3380 < f32(_e3387))));
let _e3392 = f32(_e3391);
let _e3396 = ((_e3374 - (_e3392 * 0.6933594f)) - (_e3392 * -2.1219444e-4f));
let _e3418 = -(((_e3300 + (((_e3305 + (((bitcast<f32>((((_e3250 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3305) * _e3111)) - _e3300) * _e3109)) * _e3320));
let _e3420 = select(-87f, _e3418, (_e3418 > -87f));
let _e3422 = select(88f, _e3420, (_e3420 < 88f));
let _e3424 = ((_e3422 * 1.442695f) + 0.5f);
let _e3426 = select(-127f, _e3424, (_e3424 > -127f));
let _e3428 = select(128f, _e3426, (_e3426 < 128f));
let _e3435 = select(0i, select(select(i32(_e3428), i32(-2147483648), (_e3428 < -2147483600f)), 2147483647i, (_e3428 > 2147483500f)), (_e3428 == _e3428));
let _e3439 = (_e3435 - select(0i, 1i, (_e3428 < f32(_e3435))));
let _e3440 = f32(_e3439);
let _e3444 = ((_e3422 - (_e3440 * 0.6933594f)) - (_e3440 * -2.1219444e-4f));
let _e3466 = -(((_e3161 + (((_e3166 + (((bitcast<f32>(((_e3148 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3166) * _e3111)) - _e3161) * _e3109)) * (_e3070 * _e2967.member)));
let _e3468 = select(-87f, _e3466, (_e3466 > -87f));
let _e3470 = select(88f, _e3468, (_e3468 < 88f));
let _e3472 = ((_e3470 * 1.442695f) + 0.5f);
let _e3474 = select(-127f, _e3472, (_e3472 > -127f));
let _e3476 = select(128f, _e3474, (_e3474 < 128f));
let _e3483 = select(0i, select(select(i32(_e3476), i32(-2147483648), (_e3476 < -2147483600f)), 2147483647i, (_e3476 > 2147483500f)), (_e3476 == _e3476));
let _e3487 = (_e3483 - select(0i, 1i, (_e3476 < f32(_e3483))));
let _e3488 = f32(_e3487);
let _e3492 = ((_e3470 - (_e3488 * 0.6933594f)) - (_e3488 * -2.1219444e-4f));
let _e3512 = ((1f + (_e3492 * (1f + (_e3492 * (0.5f + (_e3492 * (0.16666667f + (_e3492 * (0.041666668f + (_e3492 * (0.008333334f + (_e3492 * (0.001388889f + (_e3492 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3487 + 127i)) << bitcast<u32>(23i))));
if _e858 {
let _e3527 = global_1.member.member_5.member_4;
let _e3530 = (_e2504.member_3.x * _e2967.member_2);
let _e3532 = (_e2504.member_3.y * _e2967.member_2);
let _e3534 = (_e2504.member_3.z * _e2967.member_2);
let _e3535 = (0.5f * (_e249 / _e201));
let _e3539 = (_e179 + (_e3530 * _e3535));
let _e3540 = (_e190 + (_e3532 * _e3535));
let _e3541 = (_e201 + (_e3534 * _e3535));
let _e3543 = (2f * _e249);
let _e3545 = ((_e3541 * _e3541) + (_e3543 * _e3534));
let _e3549 = (_e3541 + sqrt(select(0f, _e3545, (_e3545 > 0f))));
let _e3553 = (0.5f * (_e3543 / select(1e-6f, _e3549, (_e3549 > 1e-6f))));
let _e3557 = (_e3539 + (_e3530 * _e3553));
let _e3558 = (_e3540 + (_e3532 * _e3553));
let _e3559 = (_e3541 + (_e3534 * _e3553));
let _e3563 = (_e3527 * _e3527);
let _e3565 = (_e3559 * _e3559);
let _e3573 = (((_e3541 <= 0f) || (_e3545 <= 0f)) || ((_e3559 <= 0f) || (_e3565 <= (_e3563 * (((_e3557 * _e3557) + (_e3558 * _e3558)) + _e3565)))));
let _e3587 = (_e179 + ((_e2504.member_4.x * _e2967.member_2) * _e249));
let _e3588 = (_e190 + ((_e2504.member_4.y * _e2967.member_2) * _e249));
let _e3589 = (_e201 + ((_e2504.member_4.z * _e2967.member_2) * _e249));
let _e3591 = (_e3589 * _e3589);
let _e3600 = ((_e841 & 1u) != 0u);
phi_7938_ = select(select(select(_e3559, _e3541, _e3573), _e3589, _e3600), _e201, _e848);
phi_7939_ = select(select(select(_e3558, _e3540, _e3573), _e3588, _e3600), _e190, _e848);
phi_7940_ = select(select(select(_e3557, _e3539, _e3573), _e3587, _e3600), _e179, _e848);
phi_7941_ = (select(_e3573, ((_e3589 <= 0f) || (_e3591 <= (_e3563 * (((_e3587 * _e3587) + (_e3588 * _e3588)) + _e3591)))), _e3600) && !(_e848));
} else {
phi_7938_ = _e201;
phi_7939_ = _e190;
phi_7940_ = _e179;
phi_7941_ = false;
}
let _e3611 = phi_7938_;
let _e3613 = phi_7939_;
let _e3615 = phi_7940_;
let _e3617 = phi_7941_;
global_6.member[_e125] = (_e136 + _e264);
global_6.member[_e137] = (_e146 + _e271);
global_6.member[_e148] = (_e157 + _e373);
global_6.member[_e159] = (_e168 + _e376);
global_6.member[_e170] = _e3615;
global_6.member[_e181] = _e3613;
global_6.member[_e192] = _e3611;
global_6.member[_e203] = select((_e212 * (((1f + (_e3348 * (1f + (_e3348 * (0.5f + (_e3348 * (0.16666667f + (_e3348 * (0.041666668f + (_e3348 * (0.008333334f + (_e3348 * (0.001388889f + (_e3348 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3343 + 127i)) << bitcast<u32>(23i)))) * _e3512)), _e212, _e848);
global_6.member[_e214] = select((_e223 * (((1f + (_e3396 * (1f + (_e3396 * (0.5f + (_e3396 * (0.16666667f + (_e3396 * (0.041666668f + (_e3396 * (0.008333334f + (_e3396 * (0.001388889f + (_e3396 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3391 + 127i)) << bitcast<u32>(23i)))) * _e3512)), _e223, _e848);
global_6.member[_e225] = select((_e234 * (((1f + (_e3444 * (1f + (_e3444 * (0.5f + (_e3444 * (0.16666667f + (_e3444 * (0.041666668f + (_e3444 * (0.008333334f + (_e3444 * (0.001388889f + (_e3444 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3439 + 127i)) << bitcast<u32>(23i)))) * _e3512)), _e234, _e848);
global_6.member[_e236] = select(_e245, 1f, _e3617);
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
