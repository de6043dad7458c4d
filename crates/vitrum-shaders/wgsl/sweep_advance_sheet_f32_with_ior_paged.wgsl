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
var phi_5472_: type_29;
var phi_6081_: type_30;
var phi_6913_: type_5;
var phi_7939_: vec3<f32>;
var phi_7940_: bool;
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
let _e250 = global_1.member.member_5.member_2;
let _e253 = (1f / select(1e-6f, _e201, (_e201 > 1e-6f)));
let _e257 = global_1.member.member_8.member_5;
let _e258 = (_e250 * _e257);
let _e263 = global_1.member.member_8.member_6;
let _e265 = (((_e179 * _e253) - _e263) * _e258);
let _e270 = global_1.member.member_8.member_7;
let _e272 = (((_e190 * _e253) - _e270) * _e258);
let _e276 = ((f32(bitcast<i32>(_e118)) - 0.5f) + _e136);
let _e280 = global_1.member.member_8.member_1;
let _e281 = (_e280 + 1u);
let _e283 = select(1u, _e281, (_e281 > 0u));
let _e284 = (_e283 == 0u);
if _e284 {
break;
}
let _e289 = ((f32(bitcast<i32>((_e120 % _e283))) - 0.5f) + _e146);
let _e293 = global_1.member.member_5.member;
let _e297 = global_1.member.member_8.member_8;
let _e298 = (_e293 - _e297);
let _e302 = global_1.member.member_8.member_2;
let _e309 = global_1.member.member_8.member_4;
let _e311 = ((_e302 + (_e263 * _e298)) + ((_e276 + 0.5f) * _e309));
let _e315 = global_1.member.member_8.member_3;
let _e320 = ((_e315 + (_e270 * _e298)) + ((_e289 + 0.5f) * _e309));
let _e326 = global_1.member.member_5.member_1;
let _e327 = (_e326 - _e297);
let _e332 = ((_e302 + (_e263 * _e327)) + (((_e276 + _e265) + 0.5f) * _e309));
let _e337 = ((_e315 + (_e270 * _e327)) + (((_e289 + _e272) + 0.5f) * _e309));
if _e284 {
break;
}
let _e340 = bitcast<i32>(((_e120 / _e283) * 3u));
let _e342 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e344 = select(_e342, _e340, (_e340 < _e342));
let _e350 = global_5.member[bitcast<u32>(select(0i, _e344, (_e344 > 0i)))];
let _e351 = (_e340 + 1i);
let _e353 = select(_e342, _e351, (_e351 < _e342));
let _e359 = global_5.member[bitcast<u32>(select(0i, _e353, (_e353 > 0i)))];
let _e360 = (_e340 + 2i);
let _e362 = select(_e342, _e360, (_e360 < _e342));
let _e368 = global_5.member[bitcast<u32>(select(0i, _e362, (_e362 > 0i)))];
let _e371 = (1f / select(1e-6f, _e368, (_e368 > 1e-6f)));
let _e374 = (((_e350 * _e371) - _e263) * _e258);
let _e377 = (((_e359 * _e371) - _e270) * _e258);
let _e389 = global_1.member.member_6.member;
let _e400 = ((((_e389.member.member * _e311) + (_e389.member.member_1 * _e320)) + (_e389.member.member_2 * _e293)) + _e389.member_1);
let _e404 = global_1.member.member_6.member_1;
let _e415 = ((((_e404.member.member * _e311) + (_e404.member.member_1 * _e320)) + (_e404.member.member_2 * _e293)) + _e404.member_1);
let _e419 = global_1.member.member_6.member_2;
let _e430 = ((((_e419.member.member * _e311) + (_e419.member.member_1 * _e320)) + (_e419.member.member_2 * _e293)) + _e419.member_1);
let _e436 = ((((_e389.member.member * _e332) + (_e389.member.member_1 * _e337)) + (_e389.member.member_2 * _e326)) + _e389.member_1);
let _e442 = ((((_e404.member.member * _e332) + (_e404.member.member_1 * _e337)) + (_e404.member.member_2 * _e326)) + _e404.member_1);
let _e448 = ((((_e419.member.member * _e332) + (_e419.member.member_1 * _e337)) + (_e419.member.member_2 * _e326)) + _e419.member_1);
let _e452 = global_1.member.member_6.member_4;
let _e457 = global_1.member.member_6.member_3.member;
let _e458 = (_e457 - 0.5f);
let _e460 = select(-0.5f, _e436, (_e436 > -0.5f));
let _e462 = select(_e458, _e460, (_e460 < _e458));
let _e467 = global_1.member.member_6.member_3.member_1;
let _e468 = (_e467 - 0.5f);
let _e470 = select(-0.5f, _e442, (_e442 > -0.5f));
let _e472 = select(_e468, _e470, (_e470 < _e468));
let _e477 = global_1.member.member_6.member_3.member_2;
let _e478 = (_e477 - 0.5f);
let _e480 = select(-0.5f, _e448, (_e448 > -0.5f));
let _e482 = select(_e478, _e480, (_e480 < _e478));
let _e483 = (_e436 - _e400);
let _e484 = (_e442 - _e415);
let _e485 = (_e448 - _e430);
let _e488 = bitcast<f32>((bitcast<u32>(_e483) & 2147483647u));
let _e491 = bitcast<f32>((bitcast<u32>(_e484) & 2147483647u));
let _e493 = select(_e491, _e488, (_e488 > _e491));
let _e496 = bitcast<f32>((bitcast<u32>(_e485) & 2147483647u));
let _e505 = bitcast<f32>((bitcast<u32>((_e436 - _e462)) & 2147483647u));
let _e508 = bitcast<f32>((bitcast<u32>((_e442 - _e472)) & 2147483647u));
let _e510 = select(_e508, _e505, (_e505 > _e508));
let _e513 = bitcast<f32>((bitcast<u32>((_e448 - _e482)) & 2147483647u));
let _e517 = (_e462 + 0.5f);
let _e518 = (_e457 - 1f);
let _e520 = select(0f, _e517, (_e517 > 0f));
let _e522 = select(_e518, _e520, (_e520 < _e518));
let _e529 = select(0i, select(select(i32(_e522), i32(-2147483648), (_e522 < -2147483600f)), 2147483647i, (_e522 > 2147483500f)), (_e522 == _e522));
let _e537 = global_1.member.member_6.member_12;
let _e538 = (_e537 & 31u);
let _e541 = (_e472 + 0.5f);
let _e542 = (_e467 - 1f);
let _e544 = select(0f, _e541, (_e541 > 0f));
let _e546 = select(_e542, _e544, (_e544 < _e542));
let _e553 = select(0i, select(select(i32(_e546), i32(-2147483648), (_e546 < -2147483600f)), 2147483647i, (_e546 > 2147483500f)), (_e546 == _e546));
let _e560 = (_e482 + 0.5f);
let _e561 = (_e477 - 1f);
let _e563 = select(0f, _e560, (_e560 > 0f));
let _e565 = select(_e561, _e563, (_e563 < _e561));
let _e572 = select(0i, select(select(i32(_e565), i32(-2147483648), (_e565 < -2147483600f)), 2147483647i, (_e565 > 2147483500f)), (_e565 == _e565));
let _e583 = global_1.member.member_6.member_9.member;
let _e589 = global_1.member.member_6.member_9.member_1;
let _e594 = global_1.member.member_6.member_10;
let _e600 = ((bitcast<i32>(_e594) + ((_e529 - select(0i, 1i, (_e522 < f32(_e529)))) >> bitcast<u32>(_e538))) + (bitcast<i32>(_e583) * (((_e553 - select(0i, 1i, (_e546 < f32(_e553)))) >> bitcast<u32>(_e538)) + (bitcast<i32>(_e589) * ((_e572 - select(0i, 1i, (_e565 < f32(_e572)))) >> bitcast<u32>(_e538))))));
let _e602 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e604 = select(_e602, _e600, (_e600 < _e602));
let _e610 = global_3.member[bitcast<u32>(select(0i, _e604, (_e604 > 0i)))];
let _e617 = global_1.member.member_7.member;
let _e632 = global_1.member.member_7.member_1;
let _e647 = global_1.member.member_7.member_2;
let _e664 = ((((_e617.member.member * _e332) + (_e617.member.member_1 * _e337)) + (_e617.member.member_2 * _e326)) + _e617.member_1);
let _e670 = ((((_e632.member.member * _e332) + (_e632.member.member_1 * _e337)) + (_e632.member.member_2 * _e326)) + _e632.member_1);
let _e676 = ((((_e647.member.member * _e332) + (_e647.member.member_1 * _e337)) + (_e647.member.member_2 * _e326)) + _e647.member_1);
let _e680 = global_1.member.member_7.member_4;
let _e685 = global_1.member.member_7.member_3.member;
let _e686 = (_e685 - 0.5f);
let _e688 = select(-0.5f, _e664, (_e664 > -0.5f));
let _e690 = select(_e686, _e688, (_e688 < _e686));
let _e695 = global_1.member.member_7.member_3.member_1;
let _e696 = (_e695 - 0.5f);
let _e698 = select(-0.5f, _e670, (_e670 > -0.5f));
let _e700 = select(_e696, _e698, (_e698 < _e696));
let _e705 = global_1.member.member_7.member_3.member_2;
let _e706 = (_e705 - 0.5f);
let _e708 = select(-0.5f, _e676, (_e676 > -0.5f));
let _e710 = select(_e706, _e708, (_e708 < _e706));
let _e716 = bitcast<f32>((bitcast<u32>((_e664 - ((((_e617.member.member * _e311) + (_e617.member.member_1 * _e320)) + (_e617.member.member_2 * _e293)) + _e617.member_1))) & 2147483647u));
let _e719 = bitcast<f32>((bitcast<u32>((_e670 - ((((_e632.member.member * _e311) + (_e632.member.member_1 * _e320)) + (_e632.member.member_2 * _e293)) + _e632.member_1))) & 2147483647u));
let _e721 = select(_e719, _e716, (_e716 > _e719));
let _e724 = bitcast<f32>((bitcast<u32>((_e676 - ((((_e647.member.member * _e311) + (_e647.member.member_1 * _e320)) + (_e647.member.member_2 * _e293)) + _e647.member_1))) & 2147483647u));
let _e733 = bitcast<f32>((bitcast<u32>((_e664 - _e690)) & 2147483647u));
let _e736 = bitcast<f32>((bitcast<u32>((_e670 - _e700)) & 2147483647u));
let _e738 = select(_e736, _e733, (_e733 > _e736));
let _e741 = bitcast<f32>((bitcast<u32>((_e676 - _e710)) & 2147483647u));
let _e745 = (_e690 + 0.5f);
let _e746 = (_e685 - 1f);
let _e748 = select(0f, _e745, (_e745 > 0f));
let _e750 = select(_e746, _e748, (_e748 < _e746));
let _e757 = select(0i, select(select(i32(_e750), i32(-2147483648), (_e750 < -2147483600f)), 2147483647i, (_e750 > 2147483500f)), (_e750 == _e750));
let _e765 = global_1.member.member_7.member_12;
let _e766 = (_e765 & 31u);
let _e769 = (_e700 + 0.5f);
let _e770 = (_e695 - 1f);
let _e772 = select(0f, _e769, (_e769 > 0f));
let _e774 = select(_e770, _e772, (_e772 < _e770));
let _e781 = select(0i, select(select(i32(_e774), i32(-2147483648), (_e774 < -2147483600f)), 2147483647i, (_e774 > 2147483500f)), (_e774 == _e774));
let _e788 = (_e710 + 0.5f);
let _e789 = (_e705 - 1f);
let _e791 = select(0f, _e788, (_e788 > 0f));
let _e793 = select(_e789, _e791, (_e791 < _e789));
let _e800 = select(0i, select(select(i32(_e793), i32(-2147483648), (_e793 < -2147483600f)), 2147483647i, (_e793 > 2147483500f)), (_e793 == _e793));
let _e811 = global_1.member.member_7.member_9.member;
let _e817 = global_1.member.member_7.member_9.member_1;
let _e822 = global_1.member.member_7.member_10;
let _e828 = ((bitcast<i32>(_e822) + ((_e757 - select(0i, 1i, (_e750 < f32(_e757)))) >> bitcast<u32>(_e766))) + (bitcast<i32>(_e811) * (((_e781 - select(0i, 1i, (_e774 < f32(_e781)))) >> bitcast<u32>(_e766)) + (bitcast<i32>(_e817) * ((_e800 - select(0i, 1i, (_e793 < f32(_e800)))) >> bitcast<u32>(_e766))))));
let _e830 = select(_e602, _e828, (_e828 < _e602));
let _e836 = global_3.member[bitcast<u32>(select(0i, _e830, (_e830 > 0i)))];
let _e842 = global_1.member.member_1;
let _e849 = (((_e842 & 64u) != 0u) || ((((select(_e496, _e493, (_e493 > _e496)) <= _e452) && ((select(_e513, _e510, (_e510 > _e513)) > _e452) || (_e610 != 0u))) && ((select(_e724, _e721, (_e721 > _e724)) <= _e680) && ((select(_e741, _e738, (_e738 > _e741)) > _e680) || (_e836 != 0u)))) && ((_e842 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e265 == 0f) && (_e272 == 0f)) && (_e374 == 0f)) && (_e377 == 0f))), _e849), (_e245 == 0f)) > 1u) {
if _e284 {
break;
}
if _e284 {
break;
}
let _e856 = (_e110.member_2 == 2u);
let _e859 = (((_e110.member_2 == 1u) || _e856) || (_e110.member_2 == 5u));
if _e859 {
let _e861 = select(-1f, _e462, (_e462 > -1f));
let _e863 = select(_e457, _e861, (_e861 < _e457));
let _e870 = select(0i, select(select(i32(_e863), i32(-2147483648), (_e863 < -2147483600f)), 2147483647i, (_e863 > 2147483500f)), (_e863 == _e863));
let _e874 = (_e870 - select(0i, 1i, (_e863 < f32(_e870))));
let _e876 = select(-1f, _e472, (_e472 > -1f));
let _e878 = select(_e467, _e876, (_e876 < _e467));
let _e885 = select(0i, select(select(i32(_e878), i32(-2147483648), (_e878 < -2147483600f)), 2147483647i, (_e878 > 2147483500f)), (_e878 == _e878));
let _e889 = (_e885 - select(0i, 1i, (_e878 < f32(_e885))));
let _e891 = select(-1f, _e482, (_e482 > -1f));
let _e893 = select(_e477, _e891, (_e891 < _e477));
let _e900 = select(0i, select(select(i32(_e893), i32(-2147483648), (_e893 < -2147483600f)), 2147483647i, (_e893 > 2147483500f)), (_e893 == _e893));
let _e904 = (_e900 - select(0i, 1i, (_e893 < f32(_e900))));
let _e908 = global_1.member.member_6.member_7;
let _e912 = global_1.member.member_6.member_8;
let _e913 = (_e874 + 1i);
let _e914 = (_e889 + 1i);
let _e915 = (_e904 + 1i);
let _e920 = global_1.member.member_6.member_11.member;
let _e926 = global_1.member.member_6.member_11.member_1;
let _e937 = ((_e913 >> bitcast<u32>(4i)) + (bitcast<i32>(_e920) * ((_e914 >> bitcast<u32>(4i)) + (bitcast<i32>(_e926) * (_e915 >> bitcast<u32>(4i))))));
let _e939 = (bitcast<i32>(_e93) - 1i);
let _e941 = select(_e939, _e937, (_e937 < _e939));
let _e947 = global_2.member[bitcast<u32>(select(0i, _e941, (_e941 > 0i)))];
let _e949 = (_e913 & 15i);
let _e952 = ((_e914 & 15i) * _e908);
let _e954 = (bitcast<i32>(_e947) + ((_e915 & 15i) * _e912));
let _e958 = (_e952 + _e908);
let _e960 = (_e952 + (2i * _e908));
let _e961 = (_e954 + _e912);
let _e963 = (_e954 + (2i * _e912));
local_6 = type_28(array<i32, 4>(_e949, (_e949 + 1i), (_e949 + 2i), (_e949 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_7 = vec3<f32>((_e462 - f32(_e874)), (_e472 - f32(_e889)), (_e482 - f32(_e904)));
let _e974 = (_e961 + _e958);
let _e977 = local_6.member[1u];
let _e978 = (_e974 + _e977);
let _e980 = select(_e939, _e978, (_e978 < _e939));
let _e985 = global_2.member[bitcast<u32>(select(0i, _e980, (_e980 > 0i)))];
let _e986 = bitcast<f32>(_e985);
let _e989 = local_6.member[2u];
let _e990 = (_e974 + _e989);
let _e992 = select(_e939, _e990, (_e990 < _e939));
let _e997 = global_2.member[bitcast<u32>(select(0i, _e992, (_e992 > 0i)))];
let _e999 = local_7[0u];
let _e1002 = (_e986 + ((bitcast<f32>(_e997) - _e986) * _e999));
let _e1003 = (_e961 + _e960);
let _e1004 = local_6.member[1u];
let _e1005 = (_e1003 + _e1004);
let _e1007 = select(_e939, _e1005, (_e1005 < _e939));
let _e1012 = global_2.member[bitcast<u32>(select(0i, _e1007, (_e1007 > 0i)))];
let _e1013 = bitcast<f32>(_e1012);
let _e1014 = local_6.member[2u];
let _e1015 = (_e1003 + _e1014);
let _e1017 = select(_e939, _e1015, (_e1015 < _e939));
let _e1022 = global_2.member[bitcast<u32>(select(0i, _e1017, (_e1017 > 0i)))];
let _e1024 = local_7[0u];
let _e1028 = (_e963 + _e958);
let _e1029 = local_6.member[1u];
let _e1030 = (_e1028 + _e1029);
let _e1032 = select(_e939, _e1030, (_e1030 < _e939));
let _e1037 = global_2.member[bitcast<u32>(select(0i, _e1032, (_e1032 > 0i)))];
let _e1038 = bitcast<f32>(_e1037);
let _e1039 = local_6.member[2u];
let _e1040 = (_e1028 + _e1039);
let _e1042 = select(_e939, _e1040, (_e1040 < _e939));
let _e1047 = global_2.member[bitcast<u32>(select(0i, _e1042, (_e1042 > 0i)))];
let _e1049 = local_7[0u];
let _e1052 = (_e1038 + ((bitcast<f32>(_e1047) - _e1038) * _e1049));
let _e1053 = (_e963 + _e960);
let _e1054 = local_6.member[1u];
let _e1055 = (_e1053 + _e1054);
let _e1057 = select(_e939, _e1055, (_e1055 < _e939));
let _e1062 = global_2.member[bitcast<u32>(select(0i, _e1057, (_e1057 > 0i)))];
let _e1063 = bitcast<f32>(_e1062);
let _e1064 = local_6.member[2u];
let _e1065 = (_e1053 + _e1064);
let _e1067 = select(_e939, _e1065, (_e1065 < _e939));
let _e1072 = global_2.member[bitcast<u32>(select(0i, _e1067, (_e1067 > 0i)))];
let _e1074 = local_7[0u];
let _e1079 = local_7[1u];
let _e1082 = (_e1002 + (((_e1013 + ((bitcast<f32>(_e1022) - _e1013) * _e1024)) - _e1002) * _e1079));
let _e1083 = local_7[1u];
let _e1088 = local_7[2u];
let _e1095 = global_1.member.member_6.member_5;
let _e1100 = global_1.member.member_6.member_6;
let _e1101 = (((_e1082 + (((_e1052 + (((_e1063 + ((bitcast<f32>(_e1072) - _e1063) * _e1074)) - _e1052) * _e1083)) - _e1082) * _e1088)) * _e1095) + _e1100);
let _e1103 = select(0f, _e1101, (_e1101 > 0f));
let _e1107 = select(-1f, _e690, (_e690 > -1f));
let _e1109 = select(_e685, _e1107, (_e1107 < _e685));
let _e1116 = select(0i, select(select(i32(_e1109), i32(-2147483648), (_e1109 < -2147483600f)), 2147483647i, (_e1109 > 2147483500f)), (_e1109 == _e1109));
let _e1120 = (_e1116 - select(0i, 1i, (_e1109 < f32(_e1116))));
let _e1122 = select(-1f, _e700, (_e700 > -1f));
let _e1124 = select(_e695, _e1122, (_e1122 < _e695));
let _e1131 = select(0i, select(select(i32(_e1124), i32(-2147483648), (_e1124 < -2147483600f)), 2147483647i, (_e1124 > 2147483500f)), (_e1124 == _e1124));
let _e1135 = (_e1131 - select(0i, 1i, (_e1124 < f32(_e1131))));
let _e1137 = select(-1f, _e710, (_e710 > -1f));
let _e1139 = select(_e705, _e1137, (_e1137 < _e705));
let _e1146 = select(0i, select(select(i32(_e1139), i32(-2147483648), (_e1139 < -2147483600f)), 2147483647i, (_e1139 > 2147483500f)), (_e1139 == _e1139));
let _e1150 = (_e1146 - select(0i, 1i, (_e1139 < f32(_e1146))));
let _e1154 = global_1.member.member_7.member_7;
let _e1158 = global_1.member.member_7.member_8;
let _e1159 = (_e1120 + 1i);
let _e1160 = (_e1135 + 1i);
let _e1161 = (_e1150 + 1i);
let _e1166 = global_1.member.member_7.member_11.member;
let _e1172 = global_1.member.member_7.member_11.member_1;
let _e1183 = ((_e1159 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1166) * ((_e1160 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1172) * (_e1161 >> bitcast<u32>(4i))))));
let _e1185 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1187 = select(_e1185, _e1183, (_e1183 < _e1185));
let _e1193 = global_7.member[bitcast<u32>(select(0i, _e1187, (_e1187 > 0i)))];
let _e1195 = (_e1159 & 15i);
let _e1198 = ((_e1160 & 15i) * _e1154);
let _e1200 = (bitcast<i32>(_e1193) + ((_e1161 & 15i) * _e1158));
let _e1204 = (_e1198 + _e1154);
let _e1206 = (_e1198 + (2i * _e1154));
let _e1208 = (_e1198 + (3i * _e1154));
let _e1209 = (_e1200 + _e1158);
let _e1211 = (_e1200 + (2i * _e1158));
let _e1213 = (_e1200 + (3i * _e1158));
local_4 = type_28(array<i32, 4>(_e1195, (_e1195 + 1i), (_e1195 + 2i), (_e1195 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e690 - f32(_e1120)), (_e700 - f32(_e1135)), (_e710 - f32(_e1150)));
let _e1224 = (_e1209 + _e1204);
let _e1227 = local_4.member[0u];
let _e1228 = (_e1224 + _e1227);
let _e1230 = select(_e1185, _e1228, (_e1228 < _e1185));
let _e1235 = global_7.member[bitcast<u32>(select(0i, _e1230, (_e1230 > 0i)))];
let _e1236 = bitcast<f32>(_e1235);
let _e1239 = local_4.member[1u];
let _e1240 = (_e1224 + _e1239);
let _e1242 = select(_e1185, _e1240, (_e1240 < _e1185));
let _e1247 = global_7.member[bitcast<u32>(select(0i, _e1242, (_e1242 > 0i)))];
let _e1248 = bitcast<f32>(_e1247);
let _e1251 = local_4.member[2u];
let _e1252 = (_e1224 + _e1251);
let _e1254 = select(_e1185, _e1252, (_e1252 < _e1185));
let _e1259 = global_7.member[bitcast<u32>(select(0i, _e1254, (_e1254 > 0i)))];
let _e1260 = bitcast<f32>(_e1259);
let _e1263 = local_4.member[3u];
let _e1264 = (_e1224 + _e1263);
let _e1266 = select(_e1185, _e1264, (_e1264 < _e1185));
let _e1271 = global_7.member[bitcast<u32>(select(0i, _e1266, (_e1266 > 0i)))];
let _e1273 = local_5[0u];
let _e1276 = (_e1236 + ((_e1248 - _e1236) * _e1273));
let _e1277 = local_5[0u];
let _e1280 = (_e1248 + ((_e1260 - _e1248) * _e1277));
let _e1281 = local_5[0u];
let _e1284 = (_e1260 + ((bitcast<f32>(_e1271) - _e1260) * _e1281));
let _e1285 = (_e1209 + _e1206);
let _e1286 = local_4.member[0u];
let _e1287 = (_e1285 + _e1286);
let _e1289 = select(_e1185, _e1287, (_e1287 < _e1185));
let _e1294 = global_7.member[bitcast<u32>(select(0i, _e1289, (_e1289 > 0i)))];
let _e1295 = bitcast<f32>(_e1294);
let _e1296 = local_4.member[1u];
let _e1297 = (_e1285 + _e1296);
let _e1299 = select(_e1185, _e1297, (_e1297 < _e1185));
let _e1304 = global_7.member[bitcast<u32>(select(0i, _e1299, (_e1299 > 0i)))];
let _e1305 = bitcast<f32>(_e1304);
let _e1306 = local_4.member[2u];
let _e1307 = (_e1285 + _e1306);
let _e1309 = select(_e1185, _e1307, (_e1307 < _e1185));
let _e1314 = global_7.member[bitcast<u32>(select(0i, _e1309, (_e1309 > 0i)))];
let _e1315 = bitcast<f32>(_e1314);
let _e1316 = local_4.member[3u];
let _e1317 = (_e1285 + _e1316);
let _e1319 = select(_e1185, _e1317, (_e1317 < _e1185));
let _e1324 = global_7.member[bitcast<u32>(select(0i, _e1319, (_e1319 > 0i)))];
let _e1326 = local_5[0u];
let _e1330 = local_5[0u];
let _e1333 = (_e1305 + ((_e1315 - _e1305) * _e1330));
let _e1334 = local_5[0u];
let _e1338 = (_e1211 + _e1204);
let _e1339 = local_4.member[0u];
let _e1340 = (_e1338 + _e1339);
let _e1342 = select(_e1185, _e1340, (_e1340 < _e1185));
let _e1347 = global_7.member[bitcast<u32>(select(0i, _e1342, (_e1342 > 0i)))];
let _e1348 = bitcast<f32>(_e1347);
let _e1349 = local_4.member[1u];
let _e1350 = (_e1338 + _e1349);
let _e1352 = select(_e1185, _e1350, (_e1350 < _e1185));
let _e1357 = global_7.member[bitcast<u32>(select(0i, _e1352, (_e1352 > 0i)))];
let _e1358 = bitcast<f32>(_e1357);
let _e1359 = local_4.member[2u];
let _e1360 = (_e1338 + _e1359);
let _e1362 = select(_e1185, _e1360, (_e1360 < _e1185));
let _e1367 = global_7.member[bitcast<u32>(select(0i, _e1362, (_e1362 > 0i)))];
let _e1368 = bitcast<f32>(_e1367);
let _e1369 = local_4.member[3u];
let _e1370 = (_e1338 + _e1369);
let _e1372 = select(_e1185, _e1370, (_e1370 < _e1185));
let _e1377 = global_7.member[bitcast<u32>(select(0i, _e1372, (_e1372 > 0i)))];
let _e1379 = local_5[0u];
let _e1382 = (_e1348 + ((_e1358 - _e1348) * _e1379));
let _e1383 = local_5[0u];
let _e1386 = (_e1358 + ((_e1368 - _e1358) * _e1383));
let _e1387 = local_5[0u];
let _e1390 = (_e1368 + ((bitcast<f32>(_e1377) - _e1368) * _e1387));
let _e1391 = (_e1211 + _e1206);
let _e1392 = local_4.member[0u];
let _e1393 = (_e1391 + _e1392);
let _e1395 = select(_e1185, _e1393, (_e1393 < _e1185));
let _e1400 = global_7.member[bitcast<u32>(select(0i, _e1395, (_e1395 > 0i)))];
let _e1401 = bitcast<f32>(_e1400);
let _e1402 = local_4.member[1u];
let _e1403 = (_e1391 + _e1402);
let _e1405 = select(_e1185, _e1403, (_e1403 < _e1185));
let _e1410 = global_7.member[bitcast<u32>(select(0i, _e1405, (_e1405 > 0i)))];
let _e1411 = bitcast<f32>(_e1410);
let _e1412 = local_4.member[2u];
let _e1413 = (_e1391 + _e1412);
let _e1415 = select(_e1185, _e1413, (_e1413 < _e1185));
let _e1420 = global_7.member[bitcast<u32>(select(0i, _e1415, (_e1415 > 0i)))];
let _e1421 = bitcast<f32>(_e1420);
let _e1422 = local_4.member[3u];
let _e1423 = (_e1391 + _e1422);
let _e1425 = select(_e1185, _e1423, (_e1423 < _e1185));
let _e1430 = global_7.member[bitcast<u32>(select(0i, _e1425, (_e1425 > 0i)))];
let _e1432 = local_5[0u];
let _e1436 = local_5[0u];
let _e1439 = (_e1411 + ((_e1421 - _e1411) * _e1436));
let _e1440 = local_5[0u];
let _e1444 = (_e1209 + _e1198);
let _e1445 = local_4.member[1u];
let _e1446 = (_e1444 + _e1445);
let _e1448 = select(_e1185, _e1446, (_e1446 < _e1185));
let _e1453 = global_7.member[bitcast<u32>(select(0i, _e1448, (_e1448 > 0i)))];
let _e1454 = bitcast<f32>(_e1453);
let _e1455 = local_4.member[2u];
let _e1456 = (_e1444 + _e1455);
let _e1458 = select(_e1185, _e1456, (_e1456 < _e1185));
let _e1463 = global_7.member[bitcast<u32>(select(0i, _e1458, (_e1458 > 0i)))];
let _e1465 = local_5[0u];
let _e1468 = (_e1454 + ((bitcast<f32>(_e1463) - _e1454) * _e1465));
let _e1469 = (_e1209 + _e1208);
let _e1470 = local_4.member[1u];
let _e1471 = (_e1469 + _e1470);
let _e1473 = select(_e1185, _e1471, (_e1471 < _e1185));
let _e1478 = global_7.member[bitcast<u32>(select(0i, _e1473, (_e1473 > 0i)))];
let _e1479 = bitcast<f32>(_e1478);
let _e1480 = local_4.member[2u];
let _e1481 = (_e1469 + _e1480);
let _e1483 = select(_e1185, _e1481, (_e1481 < _e1185));
let _e1488 = global_7.member[bitcast<u32>(select(0i, _e1483, (_e1483 > 0i)))];
let _e1490 = local_5[0u];
let _e1494 = (_e1211 + _e1198);
let _e1495 = local_4.member[1u];
let _e1496 = (_e1494 + _e1495);
let _e1498 = select(_e1185, _e1496, (_e1496 < _e1185));
let _e1503 = global_7.member[bitcast<u32>(select(0i, _e1498, (_e1498 > 0i)))];
let _e1504 = bitcast<f32>(_e1503);
let _e1505 = local_4.member[2u];
let _e1506 = (_e1494 + _e1505);
let _e1508 = select(_e1185, _e1506, (_e1506 < _e1185));
let _e1513 = global_7.member[bitcast<u32>(select(0i, _e1508, (_e1508 > 0i)))];
let _e1515 = local_5[0u];
let _e1518 = (_e1504 + ((bitcast<f32>(_e1513) - _e1504) * _e1515));
let _e1519 = (_e1211 + _e1208);
let _e1520 = local_4.member[1u];
let _e1521 = (_e1519 + _e1520);
let _e1523 = select(_e1185, _e1521, (_e1521 < _e1185));
let _e1528 = global_7.member[bitcast<u32>(select(0i, _e1523, (_e1523 > 0i)))];
let _e1529 = bitcast<f32>(_e1528);
let _e1530 = local_4.member[2u];
let _e1531 = (_e1519 + _e1530);
let _e1533 = select(_e1185, _e1531, (_e1531 < _e1185));
let _e1538 = global_7.member[bitcast<u32>(select(0i, _e1533, (_e1533 > 0i)))];
let _e1540 = local_5[0u];
let _e1544 = (_e1200 + _e1204);
let _e1545 = local_4.member[1u];
let _e1546 = (_e1544 + _e1545);
let _e1548 = select(_e1185, _e1546, (_e1546 < _e1185));
let _e1553 = global_7.member[bitcast<u32>(select(0i, _e1548, (_e1548 > 0i)))];
let _e1554 = bitcast<f32>(_e1553);
let _e1555 = local_4.member[2u];
let _e1556 = (_e1544 + _e1555);
let _e1558 = select(_e1185, _e1556, (_e1556 < _e1185));
let _e1563 = global_7.member[bitcast<u32>(select(0i, _e1558, (_e1558 > 0i)))];
let _e1565 = local_5[0u];
let _e1568 = (_e1554 + ((bitcast<f32>(_e1563) - _e1554) * _e1565));
let _e1569 = (_e1213 + _e1204);
let _e1570 = local_4.member[1u];
let _e1571 = (_e1569 + _e1570);
let _e1573 = select(_e1185, _e1571, (_e1571 < _e1185));
let _e1578 = global_7.member[bitcast<u32>(select(0i, _e1573, (_e1573 > 0i)))];
let _e1579 = bitcast<f32>(_e1578);
let _e1580 = local_4.member[2u];
let _e1581 = (_e1569 + _e1580);
let _e1583 = select(_e1185, _e1581, (_e1581 < _e1185));
let _e1588 = global_7.member[bitcast<u32>(select(0i, _e1583, (_e1583 > 0i)))];
let _e1590 = local_5[0u];
let _e1593 = (_e1579 + ((bitcast<f32>(_e1588) - _e1579) * _e1590));
let _e1594 = (_e1200 + _e1206);
let _e1595 = local_4.member[1u];
let _e1596 = (_e1594 + _e1595);
let _e1598 = select(_e1185, _e1596, (_e1596 < _e1185));
let _e1603 = global_7.member[bitcast<u32>(select(0i, _e1598, (_e1598 > 0i)))];
let _e1604 = bitcast<f32>(_e1603);
let _e1605 = local_4.member[2u];
let _e1606 = (_e1594 + _e1605);
let _e1608 = select(_e1185, _e1606, (_e1606 < _e1185));
let _e1613 = global_7.member[bitcast<u32>(select(0i, _e1608, (_e1608 > 0i)))];
let _e1615 = local_5[0u];
let _e1619 = (_e1213 + _e1206);
let _e1620 = local_4.member[1u];
let _e1621 = (_e1619 + _e1620);
let _e1623 = select(_e1185, _e1621, (_e1621 < _e1185));
let _e1628 = global_7.member[bitcast<u32>(select(0i, _e1623, (_e1623 > 0i)))];
let _e1629 = bitcast<f32>(_e1628);
let _e1630 = local_4.member[2u];
let _e1631 = (_e1619 + _e1630);
let _e1633 = select(_e1185, _e1631, (_e1631 < _e1185));
let _e1638 = global_7.member[bitcast<u32>(select(0i, _e1633, (_e1633 > 0i)))];
let _e1640 = local_5[0u];
let _e1645 = local_5[1u];
let _e1648 = (_e1280 + ((_e1333 - _e1280) * _e1645));
let _e1649 = local_5[1u];
let _e1652 = (_e1386 + ((_e1439 - _e1386) * _e1649));
let _e1653 = local_5[1u];
let _e1656 = (_e1276 + (((_e1295 + ((_e1305 - _e1295) * _e1326)) - _e1276) * _e1653));
let _e1657 = local_5[1u];
let _e1662 = local_5[2u];
let _e1666 = local_5[1u];
let _e1669 = (_e1284 + (((_e1315 + ((bitcast<f32>(_e1324) - _e1315) * _e1334)) - _e1284) * _e1666));
let _e1670 = local_5[1u];
let _e1674 = local_5[2u];
let _e1678 = local_5[1u];
let _e1681 = (_e1468 + ((_e1280 - _e1468) * _e1678));
let _e1682 = local_5[1u];
let _e1686 = local_5[2u];
let _e1690 = local_5[1u];
let _e1693 = (_e1333 + (((_e1479 + ((bitcast<f32>(_e1488) - _e1479) * _e1490)) - _e1333) * _e1690));
let _e1694 = local_5[1u];
let _e1698 = local_5[2u];
let _e1702 = local_5[1u];
let _e1705 = (_e1568 + (((_e1604 + ((bitcast<f32>(_e1613) - _e1604) * _e1615)) - _e1568) * _e1702));
let _e1706 = local_5[2u];
let _e1710 = local_5[1u];
let _e1714 = local_5[2u];
let _e1718 = local_5[2u];
let _e1725 = global_1.member.member_7.member_5;
let _e1730 = global_1.member.member_7.member_6;
let _e1731 = (((_e1648 + ((_e1652 - _e1648) * _e1718)) * _e1725) + _e1730);
let _e1733 = select(0f, _e1731, (_e1731 > 0f));
let _e1737 = (((_e1656 + (((_e1382 + (((_e1401 + ((_e1411 - _e1401) * _e1432)) - _e1382) * _e1657)) - _e1656) * _e1662)) * _e1725) + _e1730);
let _e1739 = select(0f, _e1737, (_e1737 > 0f));
let _e1741 = select(1f, _e1739, (_e1739 < 1f));
let _e1743 = (((_e1669 + (((_e1390 + (((_e1421 + ((bitcast<f32>(_e1430) - _e1421) * _e1440)) - _e1390) * _e1670)) - _e1669) * _e1674)) * _e1725) + _e1730);
let _e1745 = select(0f, _e1743, (_e1743 > 0f));
let _e1747 = select(1f, _e1745, (_e1745 < 1f));
let _e1749 = (((_e1681 + (((_e1518 + ((_e1386 - _e1518) * _e1682)) - _e1681) * _e1686)) * _e1725) + _e1730);
let _e1751 = select(0f, _e1749, (_e1749 > 0f));
let _e1753 = select(1f, _e1751, (_e1751 < 1f));
let _e1755 = (((_e1693 + (((_e1439 + (((_e1529 + ((bitcast<f32>(_e1538) - _e1529) * _e1540)) - _e1439) * _e1694)) - _e1693) * _e1698)) * _e1725) + _e1730);
let _e1757 = select(0f, _e1755, (_e1755 > 0f));
let _e1759 = select(1f, _e1757, (_e1757 < 1f));
let _e1761 = (((_e1705 + ((_e1648 - _e1705) * _e1706)) * _e1725) + _e1730);
let _e1763 = select(0f, _e1761, (_e1761 > 0f));
let _e1765 = select(1f, _e1763, (_e1763 < 1f));
let _e1767 = (((_e1652 + (((_e1593 + (((_e1629 + ((bitcast<f32>(_e1638) - _e1629) * _e1640)) - _e1593) * _e1710)) - _e1652) * _e1714)) * _e1725) + _e1730);
let _e1769 = select(0f, _e1767, (_e1767 > 0f));
let _e1771 = select(1f, _e1769, (_e1769 < 1f));
let _e1772 = (select(1f, _e1733, (_e1733 < 1f)) * 1024f);
let _e1773 = (1024f - 1f);
let _e1775 = select(0f, _e1772, (_e1772 > 0f));
let _e1777 = select(_e1773, _e1775, (_e1775 < _e1773));
let _e1784 = select(0i, select(select(i32(_e1777), i32(-2147483648), (_e1777 < -2147483600f)), 2147483647i, (_e1777 > 2147483500f)), (_e1777 == _e1777));
let _e1788 = (_e1784 - select(0i, 1i, (_e1777 < f32(_e1784))));
let _e1789 = (262147i + _e1788);
let _e1791 = (bitcast<i32>(_e100) - 1i);
let _e1793 = select(_e1791, _e1789, (_e1789 < _e1791));
let _e1799 = global_4.member[bitcast<u32>(select(0i, _e1793, (_e1793 > 0i)))];
let _e1809 = select(_e1791, 262146i, (262146i < _e1791));
let _e1815 = global_4.member[bitcast<u32>(select(0i, _e1809, (_e1809 > 0i)))];
let _e1816 = bitcast<f32>(_e1815);
let _e1817 = (f32((bitcast<i32>((_e1799 & 4095u)) - 2048i)) * _e1816);
let _e1819 = select(_e1791, 262144i, (262144i < _e1791));
let _e1825 = global_4.member[bitcast<u32>(select(0i, _e1819, (_e1819 > 0i)))];
let _e1826 = bitcast<f32>(_e1825);
let _e1828 = select(_e1791, 262145i, (262145i < _e1791));
let _e1834 = global_4.member[bitcast<u32>(select(0i, _e1828, (_e1828 > 0i)))];
let _e1835 = bitcast<f32>(_e1834);
let _e1841 = ((_e1826 + (f32(bitcast<i32>((_e1799 >> bitcast<u32>(12u)))) * _e1835)) + (_e1817 * (_e1772 - f32(_e1788))));
let _e1842 = (_e1817 * 1024f);
if _e856 {
let _e1849 = ((0.5f * (_e1747 - _e1741)) * _e1842);
let _e1850 = ((0.5f * (_e1759 - _e1753)) * _e1842);
let _e1851 = ((0.5f * (_e1771 - _e1765)) * _e1842);
phi_5472_ = type_29(_e1841, vec3<f32>(_e1849, _e1850, _e1851), vec3<f32>((_e1849 * _e1841), (_e1850 * _e1841), (_e1851 * _e1841)));
} else {
let _e1858 = (_e1741 * 1024f);
let _e1860 = select(0f, _e1858, (_e1858 > 0f));
let _e1862 = select(_e1773, _e1860, (_e1860 < _e1773));
let _e1869 = select(0i, select(select(i32(_e1862), i32(-2147483648), (_e1862 < -2147483600f)), 2147483647i, (_e1862 > 2147483500f)), (_e1862 == _e1862));
let _e1873 = (_e1869 - select(0i, 1i, (_e1862 < f32(_e1869))));
let _e1874 = (262147i + _e1873);
let _e1876 = select(_e1791, _e1874, (_e1874 < _e1791));
let _e1882 = global_4.member[bitcast<u32>(select(0i, _e1876, (_e1876 > 0i)))];
let _e1897 = ((_e1826 + (f32(bitcast<i32>((_e1882 >> bitcast<u32>(12u)))) * _e1835)) + ((f32((bitcast<i32>((_e1882 & 4095u)) - 2048i)) * _e1816) * (_e1858 - f32(_e1873))));
let _e1898 = (_e1747 * 1024f);
let _e1900 = select(0f, _e1898, (_e1898 > 0f));
let _e1902 = select(_e1773, _e1900, (_e1900 < _e1773));
let _e1909 = select(0i, select(select(i32(_e1902), i32(-2147483648), (_e1902 < -2147483600f)), 2147483647i, (_e1902 > 2147483500f)), (_e1902 == _e1902));
let _e1913 = (_e1909 - select(0i, 1i, (_e1902 < f32(_e1909))));
let _e1914 = (262147i + _e1913);
let _e1916 = select(_e1791, _e1914, (_e1914 < _e1791));
let _e1922 = global_4.member[bitcast<u32>(select(0i, _e1916, (_e1916 > 0i)))];
let _e1937 = ((_e1826 + (f32(bitcast<i32>((_e1922 >> bitcast<u32>(12u)))) * _e1835)) + ((f32((bitcast<i32>((_e1922 & 4095u)) - 2048i)) * _e1816) * (_e1898 - f32(_e1913))));
let _e1938 = (_e1753 * 1024f);
let _e1940 = select(0f, _e1938, (_e1938 > 0f));
let _e1942 = select(_e1773, _e1940, (_e1940 < _e1773));
let _e1949 = select(0i, select(select(i32(_e1942), i32(-2147483648), (_e1942 < -2147483600f)), 2147483647i, (_e1942 > 2147483500f)), (_e1942 == _e1942));
let _e1953 = (_e1949 - select(0i, 1i, (_e1942 < f32(_e1949))));
let _e1954 = (262147i + _e1953);
let _e1956 = select(_e1791, _e1954, (_e1954 < _e1791));
let _e1962 = global_4.member[bitcast<u32>(select(0i, _e1956, (_e1956 > 0i)))];
let _e1977 = ((_e1826 + (f32(bitcast<i32>((_e1962 >> bitcast<u32>(12u)))) * _e1835)) + ((f32((bitcast<i32>((_e1962 & 4095u)) - 2048i)) * _e1816) * (_e1938 - f32(_e1953))));
let _e1978 = (_e1759 * 1024f);
let _e1980 = select(0f, _e1978, (_e1978 > 0f));
let _e1982 = select(_e1773, _e1980, (_e1980 < _e1773));
let _e1989 = select(0i, select(select(i32(_e1982), i32(-2147483648), (_e1982 < -2147483600f)), 2147483647i, (_e1982 > 2147483500f)), (_e1982 == _e1982));
let _e1993 = (_e1989 - select(0i, 1i, (_e1982 < f32(_e1989))));
let _e1994 = (262147i + _e1993);
let _e1996 = select(_e1791, _e1994, (_e1994 < _e1791));
let _e2002 = global_4.member[bitcast<u32>(select(0i, _e1996, (_e1996 > 0i)))];
let _e2017 = ((_e1826 + (f32(bitcast<i32>((_e2002 >> bitcast<u32>(12u)))) * _e1835)) + ((f32((bitcast<i32>((_e2002 & 4095u)) - 2048i)) * _e1816) * (_e1978 - f32(_e1993))));
let _e2018 = (_e1765 * 1024f);
let _e2020 = select(0f, _e2018, (_e2018 > 0f));
let _e2022 = select(_e1773, _e2020, (_e2020 < _e1773));
let _e2029 = select(0i, select(select(i32(_e2022), i32(-2147483648), (_e2022 < -2147483600f)), 2147483647i, (_e2022 > 2147483500f)), (_e2022 == _e2022));
let _e2033 = (_e2029 - select(0i, 1i, (_e2022 < f32(_e2029))));
let _e2034 = (262147i + _e2033);
let _e2036 = select(_e1791, _e2034, (_e2034 < _e1791));
let _e2042 = global_4.member[bitcast<u32>(select(0i, _e2036, (_e2036 > 0i)))];
let _e2057 = ((_e1826 + (f32(bitcast<i32>((_e2042 >> bitcast<u32>(12u)))) * _e1835)) + ((f32((bitcast<i32>((_e2042 & 4095u)) - 2048i)) * _e1816) * (_e2018 - f32(_e2033))));
let _e2058 = (_e1771 * 1024f);
let _e2060 = select(0f, _e2058, (_e2058 > 0f));
let _e2062 = select(_e1773, _e2060, (_e2060 < _e1773));
let _e2069 = select(0i, select(select(i32(_e2062), i32(-2147483648), (_e2062 < -2147483600f)), 2147483647i, (_e2062 > 2147483500f)), (_e2062 == _e2062));
let _e2073 = (_e2069 - select(0i, 1i, (_e2062 < f32(_e2069))));
let _e2074 = (262147i + _e2073);
let _e2076 = select(_e1791, _e2074, (_e2074 < _e1791));
let _e2082 = global_4.member[bitcast<u32>(select(0i, _e2076, (_e2076 > 0i)))];
let _e2097 = ((_e1826 + (f32(bitcast<i32>((_e2082 >> bitcast<u32>(12u)))) * _e1835)) + ((f32((bitcast<i32>((_e2082 & 4095u)) - 2048i)) * _e1816) * (_e2058 - f32(_e2073))));
let _e2098 = (_e1937 - _e1897);
let _e2100 = (_e2017 - _e1977);
let _e2102 = (_e2097 - _e2057);
phi_5472_ = type_29(_e1841, vec3<f32>((0.5f * _e2098), (0.5f * _e2100), (0.5f * _e2102)), vec3<f32>((0.25f * (_e2098 * (_e1937 + _e1897))), (0.25f * (_e2100 * (_e2017 + _e1977))), (0.25f * (_e2102 * (_e2097 + _e2057)))));
}
let _e2117 = phi_5472_;
let _e2132 = select(0f, 1f, ((((((_e664 >= -0.5f) && (_e664 <= _e686)) && (_e670 >= -0.5f)) && (_e670 <= _e696)) && (_e676 >= -0.5f)) && (_e676 <= _e706)));
let _e2134 = (0.5f * (_e1747 - _e1741));
let _e2136 = (0.5f * (_e1759 - _e1753));
let _e2138 = (0.5f * (_e1771 - _e1765));
let _e2144 = global_1.member.member_7.member.member.member;
let _e2150 = global_1.member.member_7.member.member.member_1;
let _e2156 = global_1.member.member_7.member.member.member_2;
let _e2162 = global_1.member.member_7.member_1.member.member;
let _e2168 = global_1.member.member_7.member_1.member.member_1;
let _e2174 = global_1.member.member_7.member_1.member.member_2;
let _e2180 = global_1.member.member_7.member_2.member.member;
let _e2186 = global_1.member.member_7.member_2.member.member_1;
let _e2192 = global_1.member.member_7.member_2.member.member_2;
phi_6081_ = type_30(select(1f, _e1103, (_e1103 < 1f)), vec3<f32>(((((_e2144 * _e2134) + (_e2162 * _e2136)) + (_e2180 * _e2138)) * _e2132), ((((_e2150 * _e2134) + (_e2168 * _e2136)) + (_e2186 * _e2138)) * _e2132), ((((_e2156 * _e2134) + (_e2174 * _e2136)) + (_e2192 * _e2138)) * _e2132)), _e2117.member, vec3<f32>(((((_e2144 * _e2117.member_2.x) + (_e2162 * _e2117.member_2.y)) + (_e2180 * _e2117.member_2.z)) * _e2132), ((((_e2150 * _e2117.member_2.x) + (_e2168 * _e2117.member_2.y)) + (_e2186 * _e2117.member_2.z)) * _e2132), ((((_e2156 * _e2117.member_2.x) + (_e2174 * _e2117.member_2.y)) + (_e2192 * _e2117.member_2.z)) * _e2132)), vec3<f32>(((((_e2144 * _e2117.member_1.x) + (_e2162 * _e2117.member_1.y)) + (_e2180 * _e2117.member_1.z)) * _e2132), ((((_e2150 * _e2117.member_1.x) + (_e2168 * _e2117.member_1.y)) + (_e2186 * _e2117.member_1.z)) * _e2132), ((((_e2156 * _e2117.member_1.x) + (_e2174 * _e2117.member_1.y)) + (_e2192 * _e2117.member_1.z)) * _e2132)));
} else {
let _e2258 = select(-1f, _e462, (_e462 > -1f));
let _e2260 = select(_e457, _e2258, (_e2258 < _e457));
let _e2267 = select(0i, select(select(i32(_e2260), i32(-2147483648), (_e2260 < -2147483600f)), 2147483647i, (_e2260 > 2147483500f)), (_e2260 == _e2260));
let _e2271 = (_e2267 - select(0i, 1i, (_e2260 < f32(_e2267))));
let _e2273 = select(-1f, _e472, (_e472 > -1f));
let _e2275 = select(_e467, _e2273, (_e2273 < _e467));
let _e2282 = select(0i, select(select(i32(_e2275), i32(-2147483648), (_e2275 < -2147483600f)), 2147483647i, (_e2275 > 2147483500f)), (_e2275 == _e2275));
let _e2286 = (_e2282 - select(0i, 1i, (_e2275 < f32(_e2282))));
let _e2288 = select(-1f, _e482, (_e482 > -1f));
let _e2290 = select(_e477, _e2288, (_e2288 < _e477));
let _e2297 = select(0i, select(select(i32(_e2290), i32(-2147483648), (_e2290 < -2147483600f)), 2147483647i, (_e2290 > 2147483500f)), (_e2290 == _e2290));
let _e2301 = (_e2297 - select(0i, 1i, (_e2290 < f32(_e2297))));
let _e2305 = global_1.member.member_6.member_7;
let _e2309 = global_1.member.member_6.member_8;
let _e2310 = (_e2271 + 1i);
let _e2311 = (_e2286 + 1i);
let _e2312 = (_e2301 + 1i);
let _e2317 = global_1.member.member_6.member_11.member;
let _e2323 = global_1.member.member_6.member_11.member_1;
let _e2334 = ((_e2310 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2317) * ((_e2311 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2323) * (_e2312 >> bitcast<u32>(4i))))));
let _e2336 = (bitcast<i32>(_e93) - 1i);
let _e2338 = select(_e2336, _e2334, (_e2334 < _e2336));
let _e2344 = global_2.member[bitcast<u32>(select(0i, _e2338, (_e2338 > 0i)))];
let _e2346 = (_e2310 & 15i);
let _e2349 = ((_e2311 & 15i) * _e2305);
let _e2351 = (bitcast<i32>(_e2344) + ((_e2312 & 15i) * _e2309));
let _e2355 = (_e2349 + _e2305);
let _e2357 = (_e2349 + (2i * _e2305));
let _e2358 = (_e2351 + _e2309);
let _e2360 = (_e2351 + (2i * _e2309));
local_2 = type_28(array<i32, 4>(_e2346, (_e2346 + 1i), (_e2346 + 2i), (_e2346 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e462 - f32(_e2271)), (_e472 - f32(_e2286)), (_e482 - f32(_e2301)));
let _e2371 = (_e2358 + _e2355);
let _e2374 = local_2.member[1u];
let _e2375 = (_e2371 + _e2374);
let _e2377 = select(_e2336, _e2375, (_e2375 < _e2336));
let _e2382 = global_2.member[bitcast<u32>(select(0i, _e2377, (_e2377 > 0i)))];
let _e2383 = bitcast<f32>(_e2382);
let _e2386 = local_2.member[2u];
let _e2387 = (_e2371 + _e2386);
let _e2389 = select(_e2336, _e2387, (_e2387 < _e2336));
let _e2394 = global_2.member[bitcast<u32>(select(0i, _e2389, (_e2389 > 0i)))];
let _e2396 = local_3[0u];
let _e2399 = (_e2383 + ((bitcast<f32>(_e2394) - _e2383) * _e2396));
let _e2400 = (_e2358 + _e2357);
let _e2401 = local_2.member[1u];
let _e2402 = (_e2400 + _e2401);
let _e2404 = select(_e2336, _e2402, (_e2402 < _e2336));
let _e2409 = global_2.member[bitcast<u32>(select(0i, _e2404, (_e2404 > 0i)))];
let _e2410 = bitcast<f32>(_e2409);
let _e2411 = local_2.member[2u];
let _e2412 = (_e2400 + _e2411);
let _e2414 = select(_e2336, _e2412, (_e2412 < _e2336));
let _e2419 = global_2.member[bitcast<u32>(select(0i, _e2414, (_e2414 > 0i)))];
let _e2421 = local_3[0u];
let _e2426 = local_3[1u];
let _e2429 = (_e2399 + (((_e2410 + ((bitcast<f32>(_e2419) - _e2410) * _e2421)) - _e2399) * _e2426));
let _e2430 = (_e2360 + _e2355);
let _e2431 = local_2.member[1u];
let _e2432 = (_e2430 + _e2431);
let _e2434 = select(_e2336, _e2432, (_e2432 < _e2336));
let _e2439 = global_2.member[bitcast<u32>(select(0i, _e2434, (_e2434 > 0i)))];
let _e2440 = bitcast<f32>(_e2439);
let _e2441 = local_2.member[2u];
let _e2442 = (_e2430 + _e2441);
let _e2444 = select(_e2336, _e2442, (_e2442 < _e2336));
let _e2449 = global_2.member[bitcast<u32>(select(0i, _e2444, (_e2444 > 0i)))];
let _e2451 = local_3[0u];
let _e2454 = (_e2440 + ((bitcast<f32>(_e2449) - _e2440) * _e2451));
let _e2455 = (_e2360 + _e2357);
let _e2456 = local_2.member[1u];
let _e2457 = (_e2455 + _e2456);
let _e2459 = select(_e2336, _e2457, (_e2457 < _e2336));
let _e2464 = global_2.member[bitcast<u32>(select(0i, _e2459, (_e2459 > 0i)))];
let _e2465 = bitcast<f32>(_e2464);
let _e2466 = local_2.member[2u];
let _e2467 = (_e2455 + _e2466);
let _e2469 = select(_e2336, _e2467, (_e2467 < _e2336));
let _e2474 = global_2.member[bitcast<u32>(select(0i, _e2469, (_e2469 > 0i)))];
let _e2476 = local_3[0u];
let _e2480 = local_3[1u];
let _e2485 = local_3[2u];
let _e2492 = global_1.member.member_6.member_5;
let _e2497 = global_1.member.member_6.member_6;
let _e2498 = (((_e2429 + (((_e2454 + (((_e2465 + ((bitcast<f32>(_e2474) - _e2465) * _e2476)) - _e2454) * _e2480)) - _e2429) * _e2485)) * _e2492) + _e2497);
let _e2500 = select(0f, _e2498, (_e2498 > 0f));
phi_6081_ = type_30(select(1f, _e2500, (_e2500 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2505 = phi_6081_;
let _e2507 = select(-0.5f, _e400, (_e400 > -0.5f));
let _e2509 = select(_e458, _e2507, (_e2507 < _e458));
let _e2511 = select(-0.5f, _e415, (_e415 > -0.5f));
let _e2513 = select(_e468, _e2511, (_e2511 < _e468));
let _e2515 = select(-0.5f, _e430, (_e430 > -0.5f));
let _e2517 = select(_e478, _e2515, (_e2515 < _e478));
let _e2519 = select(-1f, _e2509, (_e2509 > -1f));
let _e2521 = select(_e457, _e2519, (_e2519 < _e457));
let _e2528 = select(0i, select(select(i32(_e2521), i32(-2147483648), (_e2521 < -2147483600f)), 2147483647i, (_e2521 > 2147483500f)), (_e2521 == _e2521));
let _e2532 = (_e2528 - select(0i, 1i, (_e2521 < f32(_e2528))));
let _e2534 = select(-1f, _e2513, (_e2513 > -1f));
let _e2536 = select(_e467, _e2534, (_e2534 < _e467));
let _e2543 = select(0i, select(select(i32(_e2536), i32(-2147483648), (_e2536 < -2147483600f)), 2147483647i, (_e2536 > 2147483500f)), (_e2536 == _e2536));
let _e2547 = (_e2543 - select(0i, 1i, (_e2536 < f32(_e2543))));
let _e2549 = select(-1f, _e2517, (_e2517 > -1f));
let _e2551 = select(_e477, _e2549, (_e2549 < _e477));
let _e2558 = select(0i, select(select(i32(_e2551), i32(-2147483648), (_e2551 < -2147483600f)), 2147483647i, (_e2551 > 2147483500f)), (_e2551 == _e2551));
let _e2562 = (_e2558 - select(0i, 1i, (_e2551 < f32(_e2558))));
let _e2566 = global_1.member.member_6.member_7;
let _e2570 = global_1.member.member_6.member_8;
let _e2571 = (_e2532 + 1i);
let _e2572 = (_e2547 + 1i);
let _e2573 = (_e2562 + 1i);
let _e2578 = global_1.member.member_6.member_11.member;
let _e2584 = global_1.member.member_6.member_11.member_1;
let _e2595 = ((_e2571 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2578) * ((_e2572 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2584) * (_e2573 >> bitcast<u32>(4i))))));
let _e2597 = (bitcast<i32>(_e93) - 1i);
let _e2599 = select(_e2597, _e2595, (_e2595 < _e2597));
let _e2605 = global_2.member[bitcast<u32>(select(0i, _e2599, (_e2599 > 0i)))];
let _e2607 = (_e2571 & 15i);
let _e2610 = ((_e2572 & 15i) * _e2566);
let _e2612 = (bitcast<i32>(_e2605) + ((_e2573 & 15i) * _e2570));
let _e2616 = (_e2610 + _e2566);
let _e2618 = (_e2610 + (2i * _e2566));
let _e2619 = (_e2612 + _e2570);
let _e2621 = (_e2612 + (2i * _e2570));
local = type_28(array<i32, 4>(_e2607, (_e2607 + 1i), (_e2607 + 2i), (_e2607 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2509 - f32(_e2532)), (_e2513 - f32(_e2547)), (_e2517 - f32(_e2562)));
let _e2632 = (_e2619 + _e2616);
let _e2635 = local.member[1u];
let _e2636 = (_e2632 + _e2635);
let _e2638 = select(_e2597, _e2636, (_e2636 < _e2597));
let _e2643 = global_2.member[bitcast<u32>(select(0i, _e2638, (_e2638 > 0i)))];
let _e2644 = bitcast<f32>(_e2643);
let _e2647 = local.member[2u];
let _e2648 = (_e2632 + _e2647);
let _e2650 = select(_e2597, _e2648, (_e2648 < _e2597));
let _e2655 = global_2.member[bitcast<u32>(select(0i, _e2650, (_e2650 > 0i)))];
let _e2657 = local_1[0u];
let _e2660 = (_e2644 + ((bitcast<f32>(_e2655) - _e2644) * _e2657));
let _e2661 = (_e2619 + _e2618);
let _e2662 = local.member[1u];
let _e2663 = (_e2661 + _e2662);
let _e2665 = select(_e2597, _e2663, (_e2663 < _e2597));
let _e2670 = global_2.member[bitcast<u32>(select(0i, _e2665, (_e2665 > 0i)))];
let _e2671 = bitcast<f32>(_e2670);
let _e2672 = local.member[2u];
let _e2673 = (_e2661 + _e2672);
let _e2675 = select(_e2597, _e2673, (_e2673 < _e2597));
let _e2680 = global_2.member[bitcast<u32>(select(0i, _e2675, (_e2675 > 0i)))];
let _e2682 = local_1[0u];
let _e2687 = local_1[1u];
let _e2690 = (_e2660 + (((_e2671 + ((bitcast<f32>(_e2680) - _e2671) * _e2682)) - _e2660) * _e2687));
let _e2691 = (_e2621 + _e2616);
let _e2692 = local.member[1u];
let _e2693 = (_e2691 + _e2692);
let _e2695 = select(_e2597, _e2693, (_e2693 < _e2597));
let _e2700 = global_2.member[bitcast<u32>(select(0i, _e2695, (_e2695 > 0i)))];
let _e2701 = bitcast<f32>(_e2700);
let _e2702 = local.member[2u];
let _e2703 = (_e2691 + _e2702);
let _e2705 = select(_e2597, _e2703, (_e2703 < _e2597));
let _e2710 = global_2.member[bitcast<u32>(select(0i, _e2705, (_e2705 > 0i)))];
let _e2712 = local_1[0u];
let _e2715 = (_e2701 + ((bitcast<f32>(_e2710) - _e2701) * _e2712));
let _e2716 = (_e2621 + _e2618);
let _e2717 = local.member[1u];
let _e2718 = (_e2716 + _e2717);
let _e2720 = select(_e2597, _e2718, (_e2718 < _e2597));
let _e2725 = global_2.member[bitcast<u32>(select(0i, _e2720, (_e2720 > 0i)))];
let _e2726 = bitcast<f32>(_e2725);
let _e2727 = local.member[2u];
let _e2728 = (_e2716 + _e2727);
let _e2730 = select(_e2597, _e2728, (_e2728 < _e2597));
let _e2735 = global_2.member[bitcast<u32>(select(0i, _e2730, (_e2730 > 0i)))];
let _e2737 = local_1[0u];
let _e2741 = local_1[1u];
let _e2746 = local_1[2u];
let _e2753 = global_1.member.member_6.member_5;
let _e2758 = global_1.member.member_6.member_6;
let _e2759 = (((_e2690 + (((_e2715 + (((_e2726 + ((bitcast<f32>(_e2735) - _e2726) * _e2737)) - _e2715) * _e2741)) - _e2690) * _e2746)) * _e2753) + _e2758);
let _e2761 = select(0f, _e2759, (_e2759 > 0f));
if ((_e842 & 16u) == 0u) {
phi_6913_ = type_5(1f, 1f, 1f);
} else {
let _e2769 = global_1.member.member_14.member;
let _e2780 = ((((_e2769.member.member * _e311) + (_e2769.member.member_1 * _e320)) + (_e2769.member.member_2 * _e293)) + _e2769.member_1);
let _e2786 = ((((_e2769.member.member * _e332) + (_e2769.member.member_1 * _e337)) + (_e2769.member.member_2 * _e326)) + _e2769.member_1);
let _e2788 = select(_e2786, _e2780, (_e2780 < _e2786));
let _e2790 = select(_e2786, _e2780, (_e2780 > _e2786));
let _e2792 = (_e2790 - _e2788);
let _e2795 = (-(_e2788) / select(1e-30f, _e2792, (_e2792 > 1e-30f)));
let _e2797 = select(0f, _e2795, (_e2795 > 0f));
let _e2803 = select(select(select(1f, _e2797, (_e2797 < 1f)), 1f, (_e2790 <= 0f)), 0f, (_e2788 > 0f));
let _e2808 = global_1.member.member_14.member_1;
let _e2809 = (_e2808 != 0u);
let _e2819 = global_1.member.member_15.member;
let _e2830 = ((((_e2819.member.member * _e311) + (_e2819.member.member_1 * _e320)) + (_e2819.member.member_2 * _e293)) + _e2819.member_1);
let _e2836 = ((((_e2819.member.member * _e332) + (_e2819.member.member_1 * _e337)) + (_e2819.member.member_2 * _e326)) + _e2819.member_1);
let _e2838 = select(_e2836, _e2830, (_e2830 < _e2836));
let _e2840 = select(_e2836, _e2830, (_e2830 > _e2836));
let _e2842 = (_e2840 - _e2838);
let _e2845 = (-(_e2838) / select(1e-30f, _e2842, (_e2842 > 1e-30f)));
let _e2847 = select(0f, _e2845, (_e2845 > 0f));
let _e2853 = select(select(select(1f, _e2847, (_e2847 < 1f)), 1f, (_e2840 <= 0f)), 0f, (_e2838 > 0f));
let _e2858 = global_1.member.member_15.member_1;
let _e2859 = (_e2858 != 0u);
let _e2869 = global_1.member.member_16.member;
let _e2880 = ((((_e2869.member.member * _e311) + (_e2869.member.member_1 * _e320)) + (_e2869.member.member_2 * _e293)) + _e2869.member_1);
let _e2886 = ((((_e2869.member.member * _e332) + (_e2869.member.member_1 * _e337)) + (_e2869.member.member_2 * _e326)) + _e2869.member_1);
let _e2888 = select(_e2886, _e2880, (_e2880 < _e2886));
let _e2890 = select(_e2886, _e2880, (_e2880 > _e2886));
let _e2892 = (_e2890 - _e2888);
let _e2895 = (-(_e2888) / select(1e-30f, _e2892, (_e2892 > 1e-30f)));
let _e2897 = select(0f, _e2895, (_e2895 > 0f));
let _e2903 = select(select(select(1f, _e2897, (_e2897 < 1f)), 1f, (_e2890 <= 0f)), 0f, (_e2888 > 0f));
let _e2908 = global_1.member.member_16.member_1;
let _e2909 = (_e2908 != 0u);
let _e2919 = global_1.member.member_17.member;
let _e2930 = ((((_e2919.member.member * _e311) + (_e2919.member.member_1 * _e320)) + (_e2919.member.member_2 * _e293)) + _e2919.member_1);
let _e2936 = ((((_e2919.member.member * _e332) + (_e2919.member.member_1 * _e337)) + (_e2919.member.member_2 * _e326)) + _e2919.member_1);
let _e2938 = select(_e2936, _e2930, (_e2930 < _e2936));
let _e2940 = select(_e2936, _e2930, (_e2930 > _e2936));
let _e2942 = (_e2940 - _e2938);
let _e2945 = (-(_e2938) / select(1e-30f, _e2942, (_e2942 > 1e-30f)));
let _e2947 = select(0f, _e2945, (_e2945 > 0f));
let _e2953 = select(select(select(1f, _e2947, (_e2947 < 1f)), 1f, (_e2940 <= 0f)), 0f, (_e2938 > 0f));
let _e2958 = global_1.member.member_17.member_1;
let _e2959 = (_e2958 != 0u);
phi_6913_ = type_5(((((1f * _e2803) * _e2853) * _e2903) * _e2953), ((((1f * select(1f, _e2803, _e2809)) * select(1f, _e2853, _e2859)) * select(1f, _e2903, _e2909)) * select(1f, _e2953, _e2959)), ((((1f * select(1f, 0f, (_e2809 && (_e2786 > 0f)))) * select(1f, 0f, (_e2859 && (_e2836 > 0f)))) * select(1f, 0f, (_e2909 && (_e2886 > 0f)))) * select(1f, 0f, (_e2959 && (_e2936 > 0f)))));
}
let _e2968 = phi_6913_;
let _e2969 = (_e332 - _e311);
let _e2970 = (_e337 - _e320);
let _e2971 = (_e326 - _e293);
let _e2976 = (((_e2969 * _e2969) + (_e2970 * _e2970)) + (_e2971 * _e2971));
let _e2980 = (_e488 < 1e-12f);
let _e2982 = (1f / select(_e483, 1f, _e2980));
let _e2984 = ((-0.5f - _e400) * _e2982);
let _e2986 = ((_e458 - _e400) * _e2982);
let _e2992 = select(_e2986, _e2984, (_e2984 < _e2986));
let _e2994 = select(0f, _e2992, (_e2992 > 0f));
let _e2997 = select(select(1f, _e2994, (_e2994 < 1f)), select(2f, 0f, ((_e400 >= -0.5f) && (_e400 <= _e458))), _e2980);
let _e2999 = select(_e2986, _e2984, (_e2984 > _e2986));
let _e3001 = select(0f, _e2999, (_e2999 > 0f));
let _e3004 = select(select(1f, _e3001, (_e3001 < 1f)), 1f, _e2980);
let _e3005 = (_e491 < 1e-12f);
let _e3007 = (1f / select(_e484, 1f, _e3005));
let _e3009 = ((-0.5f - _e415) * _e3007);
let _e3011 = ((_e468 - _e415) * _e3007);
let _e3017 = select(_e3011, _e3009, (_e3009 < _e3011));
let _e3019 = select(0f, _e3017, (_e3017 > 0f));
let _e3022 = select(select(1f, _e3019, (_e3019 < 1f)), select(2f, 0f, ((_e415 >= -0.5f) && (_e415 <= _e468))), _e3005);
let _e3024 = select(_e3011, _e3009, (_e3009 > _e3011));
let _e3026 = select(0f, _e3024, (_e3024 > 0f));
let _e3029 = select(select(1f, _e3026, (_e3026 < 1f)), 1f, _e3005);
let _e3030 = (_e496 < 1e-12f);
let _e3032 = (1f / select(_e485, 1f, _e3030));
let _e3034 = ((-0.5f - _e430) * _e3032);
let _e3036 = ((_e478 - _e430) * _e3032);
let _e3042 = select(_e3036, _e3034, (_e3034 < _e3036));
let _e3044 = select(0f, _e3042, (_e3042 > 0f));
let _e3047 = select(select(1f, _e3044, (_e3044 < 1f)), select(2f, 0f, ((_e430 >= -0.5f) && (_e430 <= _e478))), _e3030);
let _e3049 = select(_e3036, _e3034, (_e3034 > _e3036));
let _e3051 = select(0f, _e3049, (_e3049 > 0f));
let _e3054 = select(select(1f, _e3051, (_e3051 < 1f)), 1f, _e3030);
let _e3056 = select(_e3029, _e3004, (_e3004 < _e3029));
let _e3060 = select(_e3022, _e2997, (_e2997 > _e3022));
let _e3063 = (select(_e3054, _e3056, (_e3056 < _e3054)) - select(_e3047, _e3060, (_e3060 > _e3047)));
let _e3070 = global_1.member.member_5.member_3;
let _e3071 = ((sqrt(select(0f, _e2976, (_e2976 > 0f))) * select(0f, _e3063, (_e3063 > 0f))) * _e3070);
let _e3073 = (select(1f, _e2761, (_e2761 < 1f)) * 255f);
let _e3074 = (_e2505.member * 255f);
let _e3075 = (255f - 1f);
let _e3077 = select(0f, _e3073, (_e3073 > 0f));
let _e3079 = select(_e3075, _e3077, (_e3077 < _e3075));
let _e3086 = select(0i, select(select(i32(_e3079), i32(-2147483648), (_e3079 < -2147483600f)), 2147483647i, (_e3079 > 2147483500f)), (_e3079 == _e3079));
let _e3090 = (_e3086 - select(0i, 1i, (_e3079 < f32(_e3086))));
let _e3092 = select(0f, _e3074, (_e3074 > 0f));
let _e3094 = select(_e3075, _e3092, (_e3092 < _e3075));
let _e3101 = select(0i, select(select(i32(_e3094), i32(-2147483648), (_e3094 < -2147483600f)), 2147483647i, (_e3094 > 2147483500f)), (_e3094 == _e3094));
let _e3105 = (_e3101 - select(0i, 1i, (_e3094 < f32(_e3101))));
let _e3108 = (((_e3090 * 256i) + _e3105) * 4i);
let _e3110 = (_e3073 - f32(_e3090));
let _e3112 = (_e3074 - f32(_e3105));
let _e3114 = (bitcast<i32>(_e100) - 1i);
let _e3116 = select(_e3114, _e3108, (_e3108 < _e3114));
let _e3122 = global_4.member[bitcast<u32>(select(0i, _e3116, (_e3116 > 0i)))];
let _e3123 = (_e3108 + 4i);
let _e3125 = select(_e3114, _e3123, (_e3123 < _e3114));
let _e3131 = global_4.member[bitcast<u32>(select(0i, _e3125, (_e3125 > 0i)))];
let _e3132 = (_e3108 + 1024i);
let _e3134 = select(_e3114, _e3132, (_e3132 < _e3114));
let _e3140 = global_4.member[bitcast<u32>(select(0i, _e3134, (_e3134 > 0i)))];
let _e3141 = (_e3108 + 1028i);
let _e3143 = select(_e3114, _e3141, (_e3141 < _e3114));
let _e3149 = global_4.member[bitcast<u32>(select(0i, _e3143, (_e3143 > 0i)))];
let _e3154 = (bitcast<f32>(((_e3122 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3162 = (_e3154 + (((bitcast<f32>(((_e3131 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3154) * _e3112));
let _e3167 = (bitcast<f32>(((_e3140 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3191 = (bitcast<f32>((((_e3122 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3199 = (_e3191 + (((bitcast<f32>((((_e3131 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3191) * _e3112));
let _e3204 = (bitcast<f32>((((_e3140 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3216 = (_e3108 + 1i);
let _e3218 = select(_e3114, _e3216, (_e3216 < _e3114));
let _e3224 = global_4.member[bitcast<u32>(select(0i, _e3218, (_e3218 > 0i)))];
let _e3225 = (_e3108 + 5i);
let _e3227 = select(_e3114, _e3225, (_e3225 < _e3114));
let _e3233 = global_4.member[bitcast<u32>(select(0i, _e3227, (_e3227 > 0i)))];
let _e3234 = (_e3108 + 1025i);
let _e3236 = select(_e3114, _e3234, (_e3234 < _e3114));
let _e3242 = global_4.member[bitcast<u32>(select(0i, _e3236, (_e3236 > 0i)))];
let _e3243 = (_e3108 + 1029i);
let _e3245 = select(_e3114, _e3243, (_e3243 < _e3114));
let _e3251 = global_4.member[bitcast<u32>(select(0i, _e3245, (_e3245 > 0i)))];
let _e3256 = (bitcast<f32>(((_e3224 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3264 = (_e3256 + (((bitcast<f32>(((_e3233 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3256) * _e3112));
let _e3269 = (bitcast<f32>(((_e3242 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3293 = (bitcast<f32>((((_e3224 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3301 = (_e3293 + (((bitcast<f32>((((_e3233 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3293) * _e3112));
let _e3306 = (bitcast<f32>((((_e3242 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3321 = (_e3071 * _e2968.member_1);
let _e3323 = -(((_e3199 + (((_e3204 + (((bitcast<f32>((((_e3149 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3204) * _e3112)) - _e3199) * _e3110)) * _e3321));
let _e3325 = select(-87f, _e3323, (_e3323 > -87f));
let _e3327 = select(88f, _e3325, (_e3325 < 88f));
let _e3329 = ((_e3327 * 1.442695f) + 0.5f);
let _e3331 = select(-127f, _e3329, (_e3329 > -127f));
let _e3333 = select(128f, _e3331, (_e3331 < 128f));
let _e3340 = select(0i, select(select(i32(_e3333), i32(-2147483648), (_e3333 < -2147483600f)), 2147483647i, (_e3333 > 2147483500f)), (_e3333 == _e3333));
let _e3344 = (_e3340 - select(0i, 1i, (_e3333 < f32(_e3340))));
let _e3345 = f32(_e3344);
let _e3349 = ((_e3327 - (_e3345 * 0.6933594f)) - (_e3345 * -2.1219444e-4f));
let _e3371 = -(((_e3264 + (((_e3269 + (((bitcast<f32>(((_e3251 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3269) * _e3112)) - _e3264) * _e3110)) * _e3321));
let _e3373 = select(-87f, _e3371, (_e3371 > -87f));
let _e3375 = select(88f, _e3373, (_e3373 < 88f));
let _e3377 = ((_e3375 * 1.442695f) + 0.5f);
let _e3379 = select(-127f, _e3377, (_e3377 > -127f));
let _e3381 = select(128f, _e3379, (_e3379 < 128f));
let _e3388 = select(0i, select(select(i32(_e3381), i32(-2147483648), (_e3381 < -2147483600f)), 2147483647i, (_e3381 > 2147483500f)), (_e3381 == _e3381));
let _e3392 = (_e3388 - select(0i, 1i, (_e3381 < f32(_e3388))));
let _e3393 = f32(_e3392);
let _e3397 = ((_e3375 - (_e3393 * 0.6933594f)) - (_e3393 * -2.1219444e-4f));
let _e3419 = -(((_e3301 + (((_e3306 + (((bitcast<f32>((((_e3251 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3306) * _e3112)) - _e3301) * _e3110)) * _e3321));
let _e3421 = select(-87f, _e3419, (_e3419 > -87f));
let _e3423 = select(88f, _e3421, (_e3421 < 88f));
let _e3425 = ((_e3423 * 1.442695f) + 0.5f);
let _e3427 = select(-127f, _e3425, (_e3425 > -127f));
let _e3429 = select(128f, _e3427, (_e3427 < 128f));
let _e3436 = select(0i, select(select(i32(_e3429), i32(-2147483648), (_e3429 < -2147483600f)), 2147483647i, (_e3429 > 2147483500f)), (_e3429 == _e3429));
let _e3440 = (_e3436 - select(0i, 1i, (_e3429 < f32(_e3436))));
let _e3441 = f32(_e3440);
let _e3445 = ((_e3423 - (_e3441 * 0.6933594f)) - (_e3441 * -2.1219444e-4f));
let _e3467 = -(((_e3162 + (((_e3167 + (((bitcast<f32>(((_e3149 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3167) * _e3112)) - _e3162) * _e3110)) * (_e3071 * _e2968.member)));
let _e3469 = select(-87f, _e3467, (_e3467 > -87f));
let _e3471 = select(88f, _e3469, (_e3469 < 88f));
let _e3473 = ((_e3471 * 1.442695f) + 0.5f);
let _e3475 = select(-127f, _e3473, (_e3473 > -127f));
let _e3477 = select(128f, _e3475, (_e3475 < 128f));
let _e3484 = select(0i, select(select(i32(_e3477), i32(-2147483648), (_e3477 < -2147483600f)), 2147483647i, (_e3477 > 2147483500f)), (_e3477 == _e3477));
let _e3488 = (_e3484 - select(0i, 1i, (_e3477 < f32(_e3484))));
let _e3489 = f32(_e3488);
let _e3493 = ((_e3471 - (_e3489 * 0.6933594f)) - (_e3489 * -2.1219444e-4f));
let _e3513 = ((1f + (_e3493 * (1f + (_e3493 * (0.5f + (_e3493 * (0.16666667f + (_e3493 * (0.041666668f + (_e3493 * (0.008333334f + (_e3493 * (0.001388889f + (_e3493 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3488 + 127i)) << bitcast<u32>(23i))));
if _e859 {
let _e3528 = global_1.member.member_5.member_4;
let _e3531 = (_e2505.member_3.x * _e2968.member_2);
let _e3533 = (_e2505.member_3.y * _e2968.member_2);
let _e3535 = (_e2505.member_3.z * _e2968.member_2);
let _e3536 = (0.5f * (_e250 / _e201));
let _e3540 = (_e179 + (_e3531 * _e3536));
let _e3541 = (_e190 + (_e3533 * _e3536));
let _e3542 = (_e201 + (_e3535 * _e3536));
let _e3544 = (2f * _e250);
let _e3546 = ((_e3542 * _e3542) + (_e3544 * _e3535));
let _e3550 = (_e3542 + sqrt(select(0f, _e3546, (_e3546 > 0f))));
let _e3554 = (0.5f * (_e3544 / select(1e-6f, _e3550, (_e3550 > 1e-6f))));
let _e3558 = (_e3540 + (_e3531 * _e3554));
let _e3559 = (_e3541 + (_e3533 * _e3554));
let _e3560 = (_e3542 + (_e3535 * _e3554));
let _e3564 = (_e3528 * _e3528);
let _e3566 = (_e3560 * _e3560);
let _e3574 = (((_e3542 <= 0f) || (_e3546 <= 0f)) || ((_e3560 <= 0f) || (_e3566 <= (_e3564 * (((_e3558 * _e3558) + (_e3559 * _e3559)) + _e3566)))));
let _e3588 = (_e179 + ((_e2505.member_4.x * _e2968.member_2) * _e250));
let _e3589 = (_e190 + ((_e2505.member_4.y * _e2968.member_2) * _e250));
let _e3590 = (_e201 + ((_e2505.member_4.z * _e2968.member_2) * _e250));
let _e3592 = (_e3590 * _e3590);
let _e3601 = ((_e842 & 1u) != 0u);
phi_7939_ = vec3<f32>(select(select(select(_e3558, _e3540, _e3574), _e3588, _e3601), _e179, _e849), select(select(select(_e3559, _e3541, _e3574), _e3589, _e3601), _e190, _e849), select(select(select(_e3560, _e3542, _e3574), _e3590, _e3601), _e201, _e849));
phi_7940_ = (select(_e3574, ((_e3590 <= 0f) || (_e3592 <= (_e3564 * (((_e3588 * _e3588) + (_e3589 * _e3589)) + _e3592)))), _e3601) && !(_e849));
} else {
phi_7939_ = vec3<f32>(_e179, _e190, _e201);
phi_7940_ = false;
}
let _e3613 = phi_7939_;
let _e3615 = phi_7940_;
global_6.member[_e125] = (_e136 + _e265);
global_6.member[_e137] = (_e146 + _e272);
global_6.member[_e148] = (_e157 + _e374);
global_6.member[_e159] = (_e168 + _e377);
global_6.member[_e170] = _e3613.x;
global_6.member[_e181] = _e3613.y;
global_6.member[_e192] = _e3613.z;
global_6.member[_e203] = select((_e212 * (((1f + (_e3349 * (1f + (_e3349 * (0.5f + (_e3349 * (0.16666667f + (_e3349 * (0.041666668f + (_e3349 * (0.008333334f + (_e3349 * (0.001388889f + (_e3349 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3344 + 127i)) << bitcast<u32>(23i)))) * _e3513)), _e212, _e849);
global_6.member[_e214] = select((_e223 * (((1f + (_e3397 * (1f + (_e3397 * (0.5f + (_e3397 * (0.16666667f + (_e3397 * (0.041666668f + (_e3397 * (0.008333334f + (_e3397 * (0.001388889f + (_e3397 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3392 + 127i)) << bitcast<u32>(23i)))) * _e3513)), _e223, _e849);
global_6.member[_e225] = select((_e234 * (((1f + (_e3445 * (1f + (_e3445 * (0.5f + (_e3445 * (0.16666667f + (_e3445 * (0.041666668f + (_e3445 * (0.008333334f + (_e3445 * (0.001388889f + (_e3445 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3440 + 127i)) << bitcast<u32>(23i)))) * _e3513)), _e234, _e849);
global_6.member[_e236] = select(_e245, 1f, _e3615);
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
