struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_3 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_4 {
member: u32,
member_1: u32,
}
struct type_6 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_7 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_8 {
member: type_7,
member_1: f32,
}
struct type_10 {
member: type_8,
member_1: type_8,
member_2: type_8,
member_3: type_7,
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
struct type_11 {
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
struct type_12 {
member: type_7,
member_1: type_7,
}
struct type_13 {
member: type_4,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_14 {
member: type_7,
member_1: f32,
member_2: f32,
}
struct type_15 {
member: type_8,
member_1: type_8,
member_2: type_8,
member_3: u32,
member_4: type_4,
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
member_17: type_4,
member_18: type_13,
member_19: type_7,
member_20: type_14,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_17 {
member: type_8,
member_1: type_7,
}
struct type_18 {
member: type_17,
member_1: type_17,
}
struct type_19 {
member: type_8,
member_1: u32,
}
struct type_20 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_7,
member_8: type_7,
member_9: type_7,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_21 {
member: type_2,
member_1: u32,
member_2: type_3,
member_3: type_4,
member_4: type_4,
member_5: u32,
member_6: u32,
member_7: type_6,
member_8: type_10,
member_9: type_10,
member_10: type_11,
member_11: type_12,
member_12: type_15,
member_13: type_6,
member_14: type_16,
member_15: type_18,
member_16: type_19,
member_17: type_19,
member_18: type_19,
member_19: type_19,
member_20: type_7,
member_21: f32,
member_22: f32,
member_23: type_20,
}
struct type_22 {
member: type_21,
}
struct type_24 {
member: array<u32>,
}
struct type_26 {
member: array<f32>,
}
struct type_29 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_32 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_33 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_34 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: f32,
member_5: f32,
member_6: vec3<f32>,
}
struct type_35 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(1)
var<storage> global_2: type_24;
@group(0) @binding(4)
var<storage> global_3: type_24;
@group(0) @binding(6)
var<storage, read_write> global_4: type_26;
@group(0) @binding(2)
var<storage> global_5: type_24;
@group(0) @binding(3)
var<storage> global_6: type_24;
@group(0) @binding(5)
var<storage> global_7: type_26;
fn function_() {
var local: f32;
var local_1: f32;
var local_2: type_29;
var local_3: vec3<f32>;
var local_4: f32;
var local_5: f32;
var local_6: f32;
var local_7: f32;
var local_8: type_29;
var local_9: vec3<f32>;
var local_10: type_29;
var local_11: vec3<f32>;
var local_12: f32;
var local_13: f32;
var local_14: f32;
var local_15: f32;
var local_16: f32;
var local_17: f32;
var local_18: f32;
var local_19: f32;
var local_20: f32;
var local_21: f32;
var local_22: f32;
var local_23: f32;
var local_24: f32;
var local_25: f32;
var local_26: type_29;
var local_27: vec3<f32>;
var local_28: type_29;
var local_29: vec3<f32>;
var phi_902_: bool;
var phi_1082_: bool;
var phi_1085_: bool;
var phi_1269_: bool;
var phi_1893_: u32;
var phi_8609_: type_32;
var phi_9256_: type_33;
var phi_10090_: type_7;
var phi_13818_: type_35;
var phi_15137_: type_34;
var phi_15150_: vec3<f32>;
var phi_15151_: f32;
var phi_17767_: type_34;
var phi_17919_: vec3<f32>;
var phi_17920_: f32;
let _e157 = global;
let _e160 = arrayLength((&global_2.member));
let _e163 = arrayLength((&global_5.member));
let _e168 = arrayLength((&global_3.member));
let _e170 = arrayLength((&global_7.member));
let _e175 = global_1.member.member_2;
let _e178 = global_1.member.member;
let _e186 = (_e157.x + _e175.member);
let _e188 = (_e157.y + _e175.member_1);
if (_e186 < _e175.member_2) {
if (_e188 < _e175.member_3) {
let _e191 = (_e178.member * _e178.member_1);
let _e193 = ((_e188 * _e178.member) + _e186);
let _e194 = bitcast<i32>(_e193);
let _e196 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e198 = select(_e196, _e194, (_e194 < _e196));
let _e204 = global_4.member[bitcast<u32>(select(0i, _e198, (_e198 > 0i)))];
let _e205 = (_e191 + _e193);
let _e206 = bitcast<i32>(_e205);
let _e208 = select(_e196, _e206, (_e206 < _e196));
let _e214 = global_4.member[bitcast<u32>(select(0i, _e208, (_e208 > 0i)))];
let _e216 = ((2u * _e191) + _e193);
let _e217 = bitcast<i32>(_e216);
let _e219 = select(_e196, _e217, (_e217 < _e196));
let _e225 = global_4.member[bitcast<u32>(select(0i, _e219, (_e219 > 0i)))];
let _e227 = ((3u * _e191) + _e193);
let _e228 = bitcast<i32>(_e227);
let _e230 = select(_e196, _e228, (_e228 < _e196));
let _e236 = global_4.member[bitcast<u32>(select(0i, _e230, (_e230 > 0i)))];
let _e238 = ((4u * _e191) + _e193);
let _e239 = bitcast<i32>(_e238);
let _e241 = select(_e196, _e239, (_e239 < _e196));
let _e247 = global_4.member[bitcast<u32>(select(0i, _e241, (_e241 > 0i)))];
let _e249 = ((5u * _e191) + _e193);
let _e250 = bitcast<i32>(_e249);
let _e252 = select(_e196, _e250, (_e250 < _e196));
let _e258 = global_4.member[bitcast<u32>(select(0i, _e252, (_e252 > 0i)))];
let _e260 = ((6u * _e191) + _e193);
let _e261 = bitcast<i32>(_e260);
let _e263 = select(_e196, _e261, (_e261 < _e196));
let _e269 = global_4.member[bitcast<u32>(select(0i, _e263, (_e263 > 0i)))];
let _e271 = ((7u * _e191) + _e193);
let _e272 = bitcast<i32>(_e271);
let _e274 = select(_e196, _e272, (_e272 < _e196));
let _e280 = global_4.member[bitcast<u32>(select(0i, _e274, (_e274 > 0i)))];
let _e282 = ((8u * _e191) + _e193);
let _e283 = bitcast<i32>(_e282);
let _e285 = select(_e196, _e283, (_e283 < _e196));
let _e291 = global_4.member[bitcast<u32>(select(0i, _e285, (_e285 > 0i)))];
let _e296 = global_1.member.member_10.member;
let _e300 = global_1.member.member_10.member_1;
let _e301 = (_e296 * _e300);
if (_e170 >= (_e301 * 4u)) {
let _e305 = bitcast<i32>((_e188 * _e296));
let _e307 = bitcast<i32>(_e186);
let _e312 = global_7.member[bitcast<u32>((_e305 + _e307))];
let _e318 = global_7.member[bitcast<u32>(((bitcast<i32>(_e301) + _e305) + _e307))];
let _e319 = f32(_e307);
let _e321 = f32(bitcast<i32>(_e188));
let _e327 = global_1.member.member_7.member;
let _e331 = global_1.member.member_10.member_8;
let _e332 = (_e327 - _e331);
let _e336 = global_1.member.member_10.member_2;
let _e340 = global_1.member.member_10.member_6;
let _e347 = global_1.member.member_10.member_4;
let _e349 = ((_e336 + (_e340 * _e332)) + (((_e319 - _e312) + 0.5f) * _e347));
let _e353 = global_1.member.member_10.member_3;
let _e357 = global_1.member.member_10.member_7;
let _e362 = ((_e353 + (_e357 * _e332)) + (((_e321 - _e318) + 0.5f) * _e347));
let _e366 = global_1.member.member_7.member_1;
let _e367 = (_e366 - _e331);
let _e372 = ((_e336 + (_e340 * _e367)) + ((_e319 + 0.5f) * _e347));
let _e377 = ((_e353 + (_e357 * _e367)) + ((_e321 + 0.5f) * _e347));
let _e383 = global_1.member.member_9.member.member;
let _e391 = (((_e383.member * _e383.member) + (_e383.member_1 * _e383.member_1)) + (_e383.member_2 * _e383.member_2));
let _e394 = sqrt(select(0f, _e391, (_e391 > 0f)));
let _e395 = ((1.5f * _e347) * _e394);
let _e399 = (select(1f, _e395, (_e395 < 1f)) + (1f / 64f));
let _e401 = select(_e399, 0.5f, (0.5f > _e399));
let _e405 = global_1.member.member_7.member_2;
let _e408 = (_e405 / select(1e-6f, _e258, (_e258 > 1e-6f)));
let _e412 = (_e372 + (_e236 * _e408));
let _e413 = (_e377 + (_e247 * _e408));
let _e414 = (_e366 + (_e258 * _e408));
let _e418 = global_1.member.member_8.member;
let _e429 = ((((_e418.member.member * _e349) + (_e418.member.member_1 * _e362)) + (_e418.member.member_2 * _e327)) + _e418.member_1);
let _e433 = global_1.member.member_8.member_1;
let _e444 = ((((_e433.member.member * _e349) + (_e433.member.member_1 * _e362)) + (_e433.member.member_2 * _e327)) + _e433.member_1);
let _e448 = global_1.member.member_8.member_2;
let _e459 = ((((_e448.member.member * _e349) + (_e448.member.member_1 * _e362)) + (_e448.member.member_2 * _e327)) + _e448.member_1);
let _e465 = ((((_e418.member.member * _e372) + (_e418.member.member_1 * _e377)) + (_e418.member.member_2 * _e366)) + _e418.member_1);
let _e471 = ((((_e433.member.member * _e372) + (_e433.member.member_1 * _e377)) + (_e433.member.member_2 * _e366)) + _e433.member_1);
let _e477 = ((((_e448.member.member * _e372) + (_e448.member.member_1 * _e377)) + (_e448.member.member_2 * _e366)) + _e448.member_1);
let _e483 = global_1.member.member_8.member_3.member;
let _e484 = (_e483 - 1f);
let _e493 = global_1.member.member_8.member_3.member_1;
let _e494 = (_e493 - 1f);
let _e503 = global_1.member.member_8.member_3.member_2;
let _e504 = (_e503 - 1f);
let _e518 = (((((((_e429 >= 0f) && (_e429 <= _e484)) && (_e444 >= 0f)) && (_e444 <= _e494)) && (_e459 >= 0f)) && (_e459 <= _e504)) && ((((((_e465 >= 0f) && (_e465 <= _e484)) && (_e471 >= 0f)) && (_e471 <= _e494)) && (_e477 >= 0f)) && (_e477 <= _e504)));
let _e527 = ((((_e178.member_2 == 1u) || (_e178.member_2 == 5u)) || (_e178.member_2 == 6u)) || ((_e178.member_2 == 2u) || (_e178.member_2 == 7u)));
if _e527 {
let _e531 = global_1.member.member_9.member;
let _e542 = ((((_e531.member.member * _e349) + (_e531.member.member_1 * _e362)) + (_e531.member.member_2 * _e327)) + _e531.member_1);
let _e546 = global_1.member.member_9.member_1;
let _e557 = ((((_e546.member.member * _e349) + (_e546.member.member_1 * _e362)) + (_e546.member.member_2 * _e327)) + _e546.member_1);
let _e561 = global_1.member.member_9.member_2;
let _e572 = ((((_e561.member.member * _e349) + (_e561.member.member_1 * _e362)) + (_e561.member.member_2 * _e327)) + _e561.member_1);
let _e573 = (_e401 - 0.5f);
let _e574 = (_e401 + 0.5f);
let _e579 = global_1.member.member_9.member_3.member;
let _e581 = (_e579 - _e574);
let _e588 = global_1.member.member_9.member_3.member_1;
let _e590 = (_e588 - _e574);
let _e598 = global_1.member.member_9.member_3.member_2;
let _e600 = (_e598 - _e574);
let _e603 = ((((_e542 >= _e573) && (_e542 <= _e581)) && ((_e557 >= _e573) && (_e557 <= _e590))) && ((_e572 >= _e573) && (_e572 <= _e600)));
let _e606 = global_1.member.member_1;
let _e608 = ((_e606 & 16u) == 0u);
if _e608 {
phi_902_ = _e603;
} else {
let _e613 = global_1.member.member_16.member;
let _e625 = -((_e401 / _e394));
let _e630 = global_1.member.member_16.member_1;
let _e636 = global_1.member.member_17.member;
let _e652 = global_1.member.member_17.member_1;
let _e659 = global_1.member.member_18.member;
let _e675 = global_1.member.member_18.member_1;
let _e682 = global_1.member.member_19.member;
let _e698 = global_1.member.member_19.member_1;
phi_902_ = (_e603 && (((((((((_e613.member.member * _e349) + (_e613.member.member_1 * _e362)) + (_e613.member.member_2 * _e327)) + _e613.member_1) <= _e625) || (_e630 == 0u)) && ((((((_e636.member.member * _e349) + (_e636.member.member_1 * _e362)) + (_e636.member.member_2 * _e327)) + _e636.member_1) <= _e625) || (_e652 == 0u))) && ((((((_e659.member.member * _e349) + (_e659.member.member_1 * _e362)) + (_e659.member.member_2 * _e327)) + _e659.member_1) <= _e625) || (_e675 == 0u))) && ((((((_e682.member.member * _e349) + (_e682.member.member_1 * _e362)) + (_e682.member.member_2 * _e327)) + _e682.member_1) <= _e625) || (_e698 == 0u))));
}
let _e704 = phi_902_;
let _e708 = (_e372 + (_e372 - _e349));
let _e709 = (_e377 + (_e377 - _e362));
let _e710 = (_e366 + (_e366 - _e327));
let _e716 = ((((_e531.member.member * _e708) + (_e531.member.member_1 * _e709)) + (_e531.member.member_2 * _e710)) + _e531.member_1);
let _e722 = ((((_e546.member.member * _e708) + (_e546.member.member_1 * _e709)) + (_e546.member.member_2 * _e710)) + _e546.member_1);
let _e728 = ((((_e561.member.member * _e708) + (_e561.member.member_1 * _e709)) + (_e561.member.member_2 * _e710)) + _e561.member_1);
let _e739 = ((((_e716 >= _e573) && (_e716 <= _e581)) && ((_e722 >= _e573) && (_e722 <= _e590))) && ((_e728 >= _e573) && (_e728 <= _e600)));
if _e608 {
phi_1082_ = _e739;
} else {
let _e744 = global_1.member.member_16.member;
let _e756 = -((_e401 / _e394));
let _e761 = global_1.member.member_16.member_1;
let _e767 = global_1.member.member_17.member;
let _e783 = global_1.member.member_17.member_1;
let _e790 = global_1.member.member_18.member;
let _e806 = global_1.member.member_18.member_1;
let _e813 = global_1.member.member_19.member;
let _e829 = global_1.member.member_19.member_1;
phi_1082_ = (_e739 && (((((((((_e744.member.member * _e708) + (_e744.member.member_1 * _e709)) + (_e744.member.member_2 * _e710)) + _e744.member_1) <= _e756) || (_e761 == 0u)) && ((((((_e767.member.member * _e708) + (_e767.member.member_1 * _e709)) + (_e767.member.member_2 * _e710)) + _e767.member_1) <= _e756) || (_e783 == 0u))) && ((((((_e790.member.member * _e708) + (_e790.member.member_1 * _e709)) + (_e790.member.member_2 * _e710)) + _e790.member_1) <= _e756) || (_e806 == 0u))) && ((((((_e813.member.member * _e708) + (_e813.member.member_1 * _e709)) + (_e813.member.member_2 * _e710)) + _e813.member_1) <= _e756) || (_e829 == 0u))));
}
let _e835 = phi_1082_;
phi_1085_ = (_e518 && (_e704 && _e835));
} else {
phi_1085_ = _e518;
}
let _e839 = phi_1085_;
let _e844 = global_1.member.member_9.member;
let _e855 = ((((_e844.member.member * _e412) + (_e844.member.member_1 * _e413)) + (_e844.member.member_2 * _e414)) + _e844.member_1);
let _e859 = global_1.member.member_9.member_1;
let _e870 = ((((_e859.member.member * _e412) + (_e859.member.member_1 * _e413)) + (_e859.member.member_2 * _e414)) + _e859.member_1);
let _e874 = global_1.member.member_9.member_2;
let _e885 = ((((_e874.member.member * _e412) + (_e874.member.member_1 * _e413)) + (_e874.member.member_2 * _e414)) + _e874.member_1);
let _e886 = (_e401 - 0.5f);
let _e887 = (_e401 + 0.5f);
let _e892 = global_1.member.member_9.member_3.member;
let _e901 = global_1.member.member_9.member_3.member_1;
let _e911 = global_1.member.member_9.member_3.member_2;
let _e916 = ((((_e855 >= _e886) && (_e855 <= (_e892 - _e887))) && ((_e870 >= _e886) && (_e870 <= (_e901 - _e887)))) && ((_e885 >= _e886) && (_e885 <= (_e911 - _e887))));
let _e919 = global_1.member.member_1;
if ((_e919 & 16u) == 0u) {
phi_1269_ = _e916;
} else {
let _e926 = global_1.member.member_16.member;
let _e938 = -((_e401 / _e394));
let _e943 = global_1.member.member_16.member_1;
let _e949 = global_1.member.member_17.member;
let _e965 = global_1.member.member_17.member_1;
let _e972 = global_1.member.member_18.member;
let _e988 = global_1.member.member_18.member_1;
let _e995 = global_1.member.member_19.member;
let _e1011 = global_1.member.member_19.member_1;
phi_1269_ = (_e916 && (((((((((_e926.member.member * _e412) + (_e926.member.member_1 * _e413)) + (_e926.member.member_2 * _e414)) + _e926.member_1) <= _e938) || (_e943 == 0u)) && ((((((_e949.member.member * _e412) + (_e949.member.member_1 * _e413)) + (_e949.member.member_2 * _e414)) + _e949.member_1) <= _e938) || (_e965 == 0u))) && ((((((_e972.member.member * _e412) + (_e972.member.member_1 * _e413)) + (_e972.member.member_2 * _e414)) + _e972.member_1) <= _e938) || (_e988 == 0u))) && ((((((_e995.member.member * _e412) + (_e995.member.member_1 * _e413)) + (_e995.member.member_2 * _e414)) + _e995.member_1) <= _e938) || (_e1011 == 0u))));
}
let _e1017 = phi_1269_;
let _e1024 = global_1.member.member_8.member_4;
let _e1025 = (_e483 - 0.5f);
let _e1027 = select(-0.5f, _e465, (_e465 > -0.5f));
let _e1029 = select(_e1025, _e1027, (_e1027 < _e1025));
let _e1030 = (_e493 - 0.5f);
let _e1032 = select(-0.5f, _e471, (_e471 > -0.5f));
let _e1034 = select(_e1030, _e1032, (_e1032 < _e1030));
let _e1035 = (_e503 - 0.5f);
let _e1037 = select(-0.5f, _e477, (_e477 > -0.5f));
let _e1039 = select(_e1035, _e1037, (_e1037 < _e1035));
let _e1045 = bitcast<f32>((bitcast<u32>((_e465 - _e429)) & 2147483647u));
let _e1048 = bitcast<f32>((bitcast<u32>((_e471 - _e444)) & 2147483647u));
let _e1050 = select(_e1048, _e1045, (_e1045 > _e1048));
let _e1053 = bitcast<f32>((bitcast<u32>((_e477 - _e459)) & 2147483647u));
let _e1062 = bitcast<f32>((bitcast<u32>((_e465 - _e1029)) & 2147483647u));
let _e1065 = bitcast<f32>((bitcast<u32>((_e471 - _e1034)) & 2147483647u));
let _e1067 = select(_e1065, _e1062, (_e1062 > _e1065));
let _e1070 = bitcast<f32>((bitcast<u32>((_e477 - _e1039)) & 2147483647u));
let _e1074 = (_e1029 + 0.5f);
let _e1076 = select(0f, _e1074, (_e1074 > 0f));
let _e1078 = select(_e484, _e1076, (_e1076 < _e484));
let _e1085 = select(0i, select(select(i32(_e1078), i32(-2147483648), (_e1078 < -2147483600f)), 2147483647i, (_e1078 > 2147483500f)), (_e1078 == _e1078));
let _e1093 = global_1.member.member_8.member_12;
let _e1094 = (_e1093 & 31u);
let _e1097 = (_e1034 + 0.5f);
let _e1099 = select(0f, _e1097, (_e1097 > 0f));
let _e1101 = select(_e494, _e1099, (_e1099 < _e494));
let _e1108 = select(0i, select(select(i32(_e1101), i32(-2147483648), (_e1101 < -2147483600f)), 2147483647i, (_e1101 > 2147483500f)), (_e1101 == _e1101));
let _e1115 = (_e1039 + 0.5f);
let _e1117 = select(0f, _e1115, (_e1115 > 0f));
let _e1119 = select(_e504, _e1117, (_e1117 < _e504));
let _e1126 = select(0i, select(select(i32(_e1119), i32(-2147483648), (_e1119 < -2147483600f)), 2147483647i, (_e1119 > 2147483500f)), (_e1119 == _e1119));
let _e1137 = global_1.member.member_8.member_9.member;
let _e1143 = global_1.member.member_8.member_9.member_1;
let _e1148 = global_1.member.member_8.member_10;
let _e1154 = ((bitcast<i32>(_e1148) + ((_e1085 - select(0i, 1i, (_e1078 < f32(_e1085)))) >> bitcast<u32>(_e1094))) + (bitcast<i32>(_e1137) * (((_e1108 - select(0i, 1i, (_e1101 < f32(_e1108)))) >> bitcast<u32>(_e1094)) + (bitcast<i32>(_e1143) * ((_e1126 - select(0i, 1i, (_e1119 < f32(_e1126)))) >> bitcast<u32>(_e1094))))));
let _e1156 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e1158 = select(_e1156, _e1154, (_e1154 < _e1156));
let _e1164 = global_6.member[bitcast<u32>(select(0i, _e1158, (_e1158 > 0i)))];
let _e1191 = ((((_e844.member.member * _e372) + (_e844.member.member_1 * _e377)) + (_e844.member.member_2 * _e366)) + _e844.member_1);
let _e1197 = ((((_e859.member.member * _e372) + (_e859.member.member_1 * _e377)) + (_e859.member.member_2 * _e366)) + _e859.member_1);
let _e1203 = ((((_e874.member.member * _e372) + (_e874.member.member_1 * _e377)) + (_e874.member.member_2 * _e366)) + _e874.member_1);
let _e1207 = global_1.member.member_9.member_4;
let _e1208 = (_e892 - 0.5f);
let _e1210 = select(-0.5f, _e1191, (_e1191 > -0.5f));
let _e1212 = select(_e1208, _e1210, (_e1210 < _e1208));
let _e1213 = (_e901 - 0.5f);
let _e1215 = select(-0.5f, _e1197, (_e1197 > -0.5f));
let _e1217 = select(_e1213, _e1215, (_e1215 < _e1213));
let _e1218 = (_e911 - 0.5f);
let _e1220 = select(-0.5f, _e1203, (_e1203 > -0.5f));
let _e1222 = select(_e1218, _e1220, (_e1220 < _e1218));
let _e1228 = bitcast<f32>((bitcast<u32>((_e1191 - ((((_e844.member.member * _e349) + (_e844.member.member_1 * _e362)) + (_e844.member.member_2 * _e327)) + _e844.member_1))) & 2147483647u));
let _e1231 = bitcast<f32>((bitcast<u32>((_e1197 - ((((_e859.member.member * _e349) + (_e859.member.member_1 * _e362)) + (_e859.member.member_2 * _e327)) + _e859.member_1))) & 2147483647u));
let _e1233 = select(_e1231, _e1228, (_e1228 > _e1231));
let _e1236 = bitcast<f32>((bitcast<u32>((_e1203 - ((((_e874.member.member * _e349) + (_e874.member.member_1 * _e362)) + (_e874.member.member_2 * _e327)) + _e874.member_1))) & 2147483647u));
let _e1245 = bitcast<f32>((bitcast<u32>((_e1191 - _e1212)) & 2147483647u));
let _e1248 = bitcast<f32>((bitcast<u32>((_e1197 - _e1217)) & 2147483647u));
let _e1250 = select(_e1248, _e1245, (_e1245 > _e1248));
let _e1253 = bitcast<f32>((bitcast<u32>((_e1203 - _e1222)) & 2147483647u));
let _e1257 = (_e1212 + 0.5f);
let _e1258 = (_e892 - 1f);
let _e1260 = select(0f, _e1257, (_e1257 > 0f));
let _e1262 = select(_e1258, _e1260, (_e1260 < _e1258));
let _e1269 = select(0i, select(select(i32(_e1262), i32(-2147483648), (_e1262 < -2147483600f)), 2147483647i, (_e1262 > 2147483500f)), (_e1262 == _e1262));
let _e1277 = global_1.member.member_9.member_12;
let _e1278 = (_e1277 & 31u);
let _e1281 = (_e1217 + 0.5f);
let _e1282 = (_e901 - 1f);
let _e1284 = select(0f, _e1281, (_e1281 > 0f));
let _e1286 = select(_e1282, _e1284, (_e1284 < _e1282));
let _e1293 = select(0i, select(select(i32(_e1286), i32(-2147483648), (_e1286 < -2147483600f)), 2147483647i, (_e1286 > 2147483500f)), (_e1286 == _e1286));
let _e1300 = (_e1222 + 0.5f);
let _e1301 = (_e911 - 1f);
let _e1303 = select(0f, _e1300, (_e1300 > 0f));
let _e1305 = select(_e1301, _e1303, (_e1303 < _e1301));
let _e1312 = select(0i, select(select(i32(_e1305), i32(-2147483648), (_e1305 < -2147483600f)), 2147483647i, (_e1305 > 2147483500f)), (_e1305 == _e1305));
let _e1323 = global_1.member.member_9.member_9.member;
let _e1329 = global_1.member.member_9.member_9.member_1;
let _e1334 = global_1.member.member_9.member_10;
let _e1340 = ((bitcast<i32>(_e1334) + ((_e1269 - select(0i, 1i, (_e1262 < f32(_e1269)))) >> bitcast<u32>(_e1278))) + (bitcast<i32>(_e1323) * (((_e1293 - select(0i, 1i, (_e1286 < f32(_e1293)))) >> bitcast<u32>(_e1278)) + (bitcast<i32>(_e1329) * ((_e1312 - select(0i, 1i, (_e1305 < f32(_e1312)))) >> bitcast<u32>(_e1278))))));
let _e1342 = select(_e1156, _e1340, (_e1340 < _e1156));
let _e1348 = global_6.member[bitcast<u32>(select(0i, _e1342, (_e1342 > 0i)))];
phi_1893_ = select(select(7u, 3u, (_e839 && (!(_e527) || _e1017))), 1u, (((_e919 & 64u) != 0u) || ((((select(_e1053, _e1050, (_e1050 > _e1053)) <= _e1024) && ((select(_e1070, _e1067, (_e1067 > _e1070)) > _e1024) || (_e1164 != 0u))) && ((select(_e1236, _e1233, (_e1233 > _e1236)) <= _e1207) && ((select(_e1253, _e1250, (_e1250 > _e1253)) > _e1207) || (_e1348 != 0u)))) && ((_e919 & 32u) != 0u))));
} else {
phi_1893_ = 7u;
}
let _e1361 = phi_1893_;
if (_e1361 > 1u) {
let _e1366 = bitcast<i32>(((_e188 * _e296) + _e186));
let _e1369 = (bitcast<i32>(_e170) - 1i);
let _e1371 = select(_e1369, _e1366, (_e1366 < _e1369));
let _e1377 = global_7.member[bitcast<u32>(select(0i, _e1371, (_e1371 > 0i)))];
let _e1378 = (bitcast<i32>(_e301) + _e1366);
let _e1380 = select(_e1369, _e1378, (_e1378 < _e1369));
let _e1386 = global_7.member[bitcast<u32>(select(0i, _e1380, (_e1380 > 0i)))];
let _e1388 = f32(bitcast<i32>(_e186));
let _e1390 = f32(bitcast<i32>(_e188));
let _e1396 = global_1.member.member_7.member;
let _e1400 = global_1.member.member_10.member_8;
let _e1401 = (_e1396 - _e1400);
let _e1405 = global_1.member.member_10.member_2;
let _e1409 = global_1.member.member_10.member_6;
let _e1416 = global_1.member.member_10.member_4;
let _e1418 = ((_e1405 + (_e1409 * _e1401)) + (((_e1388 - _e1377) + 0.5f) * _e1416));
let _e1422 = global_1.member.member_10.member_3;
let _e1426 = global_1.member.member_10.member_7;
let _e1431 = ((_e1422 + (_e1426 * _e1401)) + (((_e1390 - _e1386) + 0.5f) * _e1416));
let _e1435 = global_1.member.member_7.member_1;
let _e1436 = (_e1435 - _e1400);
let _e1441 = ((_e1405 + (_e1409 * _e1436)) + ((_e1388 + 0.5f) * _e1416));
let _e1446 = ((_e1422 + (_e1426 * _e1436)) + ((_e1390 + 0.5f) * _e1416));
let _e1450 = global_1.member.member_8.member;
let _e1461 = ((((_e1450.member.member * _e1418) + (_e1450.member.member_1 * _e1431)) + (_e1450.member.member_2 * _e1396)) + _e1450.member_1);
let _e1465 = global_1.member.member_8.member_1;
let _e1476 = ((((_e1465.member.member * _e1418) + (_e1465.member.member_1 * _e1431)) + (_e1465.member.member_2 * _e1396)) + _e1465.member_1);
let _e1480 = global_1.member.member_8.member_2;
let _e1491 = ((((_e1480.member.member * _e1418) + (_e1480.member.member_1 * _e1431)) + (_e1480.member.member_2 * _e1396)) + _e1480.member_1);
let _e1497 = ((((_e1450.member.member * _e1441) + (_e1450.member.member_1 * _e1446)) + (_e1450.member.member_2 * _e1435)) + _e1450.member_1);
let _e1503 = ((((_e1465.member.member * _e1441) + (_e1465.member.member_1 * _e1446)) + (_e1465.member.member_2 * _e1435)) + _e1465.member_1);
let _e1509 = ((((_e1480.member.member * _e1441) + (_e1480.member.member_1 * _e1446)) + (_e1480.member.member_2 * _e1435)) + _e1480.member_1);
let _e1513 = global_1.member.member_9.member;
let _e1524 = ((((_e1513.member.member * _e1441) + (_e1513.member.member_1 * _e1446)) + (_e1513.member.member_2 * _e1435)) + _e1513.member_1);
let _e1528 = global_1.member.member_9.member_1;
let _e1539 = ((((_e1528.member.member * _e1441) + (_e1528.member.member_1 * _e1446)) + (_e1528.member.member_2 * _e1435)) + _e1528.member_1);
let _e1543 = global_1.member.member_9.member_2;
let _e1554 = ((((_e1543.member.member * _e1441) + (_e1543.member.member_1 * _e1446)) + (_e1543.member.member_2 * _e1435)) + _e1543.member_1);
let _e1556 = (_e178.member_2 == 5u);
let _e1562 = ((_e178.member_2 == 2u) || (_e178.member_2 == 7u));
let _e1563 = ((((_e178.member_2 == 1u) || _e1556) || (_e178.member_2 == 6u)) || _e1562);
if _e1563 {
let _e1568 = global_1.member.member_8.member_3.member;
let _e1569 = (_e1568 - 0.5f);
let _e1571 = select(-0.5f, _e1497, (_e1497 > -0.5f));
let _e1573 = select(_e1569, _e1571, (_e1571 < _e1569));
let _e1578 = global_1.member.member_8.member_3.member_1;
let _e1579 = (_e1578 - 0.5f);
let _e1581 = select(-0.5f, _e1503, (_e1503 > -0.5f));
let _e1583 = select(_e1579, _e1581, (_e1581 < _e1579));
let _e1588 = global_1.member.member_8.member_3.member_2;
let _e1589 = (_e1588 - 0.5f);
let _e1591 = select(-0.5f, _e1509, (_e1509 > -0.5f));
let _e1593 = select(_e1589, _e1591, (_e1591 < _e1589));
let _e1595 = select(-1f, _e1573, (_e1573 > -1f));
let _e1597 = select(_e1568, _e1595, (_e1595 < _e1568));
let _e1604 = select(0i, select(select(i32(_e1597), i32(-2147483648), (_e1597 < -2147483600f)), 2147483647i, (_e1597 > 2147483500f)), (_e1597 == _e1597));
let _e1608 = (_e1604 - select(0i, 1i, (_e1597 < f32(_e1604))));
let _e1610 = select(-1f, _e1583, (_e1583 > -1f));
let _e1612 = select(_e1578, _e1610, (_e1610 < _e1578));
let _e1619 = select(0i, select(select(i32(_e1612), i32(-2147483648), (_e1612 < -2147483600f)), 2147483647i, (_e1612 > 2147483500f)), (_e1612 == _e1612));
let _e1623 = (_e1619 - select(0i, 1i, (_e1612 < f32(_e1619))));
let _e1625 = select(-1f, _e1593, (_e1593 > -1f));
let _e1627 = select(_e1588, _e1625, (_e1625 < _e1588));
let _e1634 = select(0i, select(select(i32(_e1627), i32(-2147483648), (_e1627 < -2147483600f)), 2147483647i, (_e1627 > 2147483500f)), (_e1627 == _e1627));
let _e1638 = (_e1634 - select(0i, 1i, (_e1627 < f32(_e1634))));
let _e1642 = global_1.member.member_8.member_7;
let _e1646 = global_1.member.member_8.member_8;
let _e1654 = (select(0i, select(select(i32(_e1578), i32(-2147483648), (_e1578 < -2147483600f)), 2147483647i, (_e1578 > 2147483500f)), (_e1578 == _e1578)) - 1i);
let _e1657 = (_e1623 + 1i);
let _e1667 = (select(0i, select(select(i32(_e1588), i32(-2147483648), (_e1588 < -2147483600f)), 2147483647i, (_e1588 > 2147483500f)), (_e1588 == _e1588)) - 1i);
let _e1670 = (_e1638 + 1i);
let _e1680 = (select(0i, select(select(i32(_e1568), i32(-2147483648), (_e1568 < -2147483600f)), 2147483647i, (_e1568 > 2147483500f)), (_e1568 == _e1568)) - 1i);
let _e1681 = (_e1608 - 1i);
let _e1686 = (_e1608 + 1i);
let _e1689 = (_e1608 + 2i);
let _e1692 = (select(0i, _e1623, (_e1623 > 0i)) * _e1642);
let _e1693 = (select(_e1654, _e1657, (_e1657 < _e1654)) * _e1642);
let _e1694 = (select(0i, _e1638, (_e1638 > 0i)) * _e1646);
let _e1695 = (select(_e1667, _e1670, (_e1670 < _e1667)) * _e1646);
local_28 = type_29(array<i32, 4>(select(0i, _e1681, (_e1681 > 0i)), select(0i, _e1608, (_e1608 > 0i)), select(_e1680, _e1686, (_e1686 < _e1680)), select(_e1680, _e1689, (_e1689 < _e1680))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_29 = vec3<f32>((_e1573 - f32(_e1608)), (_e1583 - f32(_e1623)), (_e1593 - f32(_e1638)));
let _e1706 = (_e1694 + _e1692);
let _e1708 = (bitcast<i32>(_e160) - 1i);
let _e1711 = local_28.member[1u];
let _e1712 = (_e1706 + _e1711);
let _e1714 = select(_e1708, _e1712, (_e1712 < _e1708));
let _e1719 = global_2.member[bitcast<u32>(select(0i, _e1714, (_e1714 > 0i)))];
let _e1720 = bitcast<f32>(_e1719);
let _e1723 = local_28.member[2u];
let _e1724 = (_e1706 + _e1723);
let _e1726 = select(_e1708, _e1724, (_e1724 < _e1708));
let _e1731 = global_2.member[bitcast<u32>(select(0i, _e1726, (_e1726 > 0i)))];
let _e1733 = local_29[0u];
let _e1736 = (_e1720 + ((bitcast<f32>(_e1731) - _e1720) * _e1733));
let _e1737 = (_e1694 + _e1693);
let _e1738 = local_28.member[1u];
let _e1739 = (_e1737 + _e1738);
let _e1741 = select(_e1708, _e1739, (_e1739 < _e1708));
let _e1746 = global_2.member[bitcast<u32>(select(0i, _e1741, (_e1741 > 0i)))];
let _e1747 = bitcast<f32>(_e1746);
let _e1748 = local_28.member[2u];
let _e1749 = (_e1737 + _e1748);
let _e1751 = select(_e1708, _e1749, (_e1749 < _e1708));
let _e1756 = global_2.member[bitcast<u32>(select(0i, _e1751, (_e1751 > 0i)))];
let _e1758 = local_29[0u];
let _e1762 = (_e1695 + _e1692);
let _e1763 = local_28.member[1u];
let _e1764 = (_e1762 + _e1763);
let _e1766 = select(_e1708, _e1764, (_e1764 < _e1708));
let _e1771 = global_2.member[bitcast<u32>(select(0i, _e1766, (_e1766 > 0i)))];
let _e1772 = bitcast<f32>(_e1771);
let _e1773 = local_28.member[2u];
let _e1774 = (_e1762 + _e1773);
let _e1776 = select(_e1708, _e1774, (_e1774 < _e1708));
let _e1781 = global_2.member[bitcast<u32>(select(0i, _e1776, (_e1776 > 0i)))];
let _e1783 = local_29[0u];
let _e1786 = (_e1772 + ((bitcast<f32>(_e1781) - _e1772) * _e1783));
let _e1787 = (_e1695 + _e1693);
let _e1788 = local_28.member[1u];
let _e1789 = (_e1787 + _e1788);
let _e1791 = select(_e1708, _e1789, (_e1789 < _e1708));
let _e1796 = global_2.member[bitcast<u32>(select(0i, _e1791, (_e1791 > 0i)))];
let _e1797 = bitcast<f32>(_e1796);
let _e1798 = local_28.member[2u];
let _e1799 = (_e1787 + _e1798);
let _e1801 = select(_e1708, _e1799, (_e1799 < _e1708));
let _e1806 = global_2.member[bitcast<u32>(select(0i, _e1801, (_e1801 > 0i)))];
let _e1808 = local_29[0u];
let _e1813 = local_29[1u];
let _e1816 = (_e1736 + (((_e1747 + ((bitcast<f32>(_e1756) - _e1747) * _e1758)) - _e1736) * _e1813));
let _e1817 = local_29[1u];
let _e1822 = local_29[2u];
let _e1829 = global_1.member.member_8.member_6;
let _e1833 = global_1.member.member_8.member_5;
let _e1835 = (((_e1816 + (((_e1786 + (((_e1797 + ((bitcast<f32>(_e1806) - _e1797) * _e1808)) - _e1786) * _e1817)) - _e1816) * _e1822)) - _e1829) * _e1833);
let _e1836 = -(1e9f);
let _e1838 = select(_e1836, _e1835, (_e1835 > _e1836));
let _e1845 = global_1.member.member_9.member_3.member;
let _e1846 = (_e1845 - 0.5f);
let _e1848 = select(-0.5f, _e1524, (_e1524 > -0.5f));
let _e1850 = select(_e1846, _e1848, (_e1848 < _e1846));
let _e1855 = global_1.member.member_9.member_3.member_1;
let _e1856 = (_e1855 - 0.5f);
let _e1858 = select(-0.5f, _e1539, (_e1539 > -0.5f));
let _e1860 = select(_e1856, _e1858, (_e1858 < _e1856));
let _e1865 = global_1.member.member_9.member_3.member_2;
let _e1866 = (_e1865 - 0.5f);
let _e1868 = select(-0.5f, _e1554, (_e1554 > -0.5f));
let _e1870 = select(_e1866, _e1868, (_e1868 < _e1866));
let _e1872 = select(-1f, _e1850, (_e1850 > -1f));
let _e1874 = select(_e1845, _e1872, (_e1872 < _e1845));
let _e1881 = select(0i, select(select(i32(_e1874), i32(-2147483648), (_e1874 < -2147483600f)), 2147483647i, (_e1874 > 2147483500f)), (_e1874 == _e1874));
let _e1885 = (_e1881 - select(0i, 1i, (_e1874 < f32(_e1881))));
let _e1887 = select(-1f, _e1860, (_e1860 > -1f));
let _e1889 = select(_e1855, _e1887, (_e1887 < _e1855));
let _e1896 = select(0i, select(select(i32(_e1889), i32(-2147483648), (_e1889 < -2147483600f)), 2147483647i, (_e1889 > 2147483500f)), (_e1889 == _e1889));
let _e1900 = (_e1896 - select(0i, 1i, (_e1889 < f32(_e1896))));
let _e1902 = select(-1f, _e1870, (_e1870 > -1f));
let _e1904 = select(_e1865, _e1902, (_e1902 < _e1865));
let _e1911 = select(0i, select(select(i32(_e1904), i32(-2147483648), (_e1904 < -2147483600f)), 2147483647i, (_e1904 > 2147483500f)), (_e1904 == _e1904));
let _e1915 = (_e1911 - select(0i, 1i, (_e1904 < f32(_e1911))));
let _e1919 = global_1.member.member_9.member_7;
let _e1923 = global_1.member.member_9.member_8;
let _e1931 = (select(0i, select(select(i32(_e1855), i32(-2147483648), (_e1855 < -2147483600f)), 2147483647i, (_e1855 > 2147483500f)), (_e1855 == _e1855)) - 1i);
let _e1932 = (_e1900 - 1i);
let _e1937 = (_e1900 + 1i);
let _e1940 = (_e1900 + 2i);
let _e1950 = (select(0i, select(select(i32(_e1865), i32(-2147483648), (_e1865 < -2147483600f)), 2147483647i, (_e1865 > 2147483500f)), (_e1865 == _e1865)) - 1i);
let _e1951 = (_e1915 - 1i);
let _e1956 = (_e1915 + 1i);
let _e1959 = (_e1915 + 2i);
let _e1969 = (select(0i, select(select(i32(_e1845), i32(-2147483648), (_e1845 < -2147483600f)), 2147483647i, (_e1845 > 2147483500f)), (_e1845 == _e1845)) - 1i);
let _e1970 = (_e1885 - 1i);
let _e1975 = (_e1885 + 1i);
let _e1978 = (_e1885 + 2i);
let _e1981 = (select(0i, _e1932, (_e1932 > 0i)) * _e1919);
let _e1982 = (select(0i, _e1900, (_e1900 > 0i)) * _e1919);
let _e1983 = (select(_e1931, _e1937, (_e1937 < _e1931)) * _e1919);
let _e1984 = (select(_e1931, _e1940, (_e1940 < _e1931)) * _e1919);
let _e1985 = (select(0i, _e1951, (_e1951 > 0i)) * _e1923);
let _e1986 = (select(0i, _e1915, (_e1915 > 0i)) * _e1923);
let _e1987 = (select(_e1950, _e1956, (_e1956 < _e1950)) * _e1923);
let _e1988 = (select(_e1950, _e1959, (_e1959 < _e1950)) * _e1923);
local_26 = type_29(array<i32, 4>(select(0i, _e1970, (_e1970 > 0i)), select(0i, _e1885, (_e1885 > 0i)), select(_e1969, _e1975, (_e1975 < _e1969)), select(_e1969, _e1978, (_e1978 < _e1969))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_27 = vec3<f32>((_e1850 - f32(_e1885)), (_e1860 - f32(_e1900)), (_e1870 - f32(_e1915)));
let _e1999 = (_e1986 + _e1982);
let _e2002 = local_26.member[0u];
let _e2003 = (_e1999 + _e2002);
let _e2005 = (bitcast<i32>(_e163) - 1i);
let _e2007 = select(_e2005, _e2003, (_e2003 < _e2005));
let _e2012 = global_5.member[bitcast<u32>(select(0i, _e2007, (_e2007 > 0i)))];
let _e2013 = bitcast<f32>(_e2012);
let _e2016 = local_26.member[1u];
let _e2017 = (_e1999 + _e2016);
let _e2019 = select(_e2005, _e2017, (_e2017 < _e2005));
let _e2024 = global_5.member[bitcast<u32>(select(0i, _e2019, (_e2019 > 0i)))];
let _e2025 = bitcast<f32>(_e2024);
let _e2028 = local_26.member[2u];
let _e2029 = (_e1999 + _e2028);
let _e2031 = select(_e2005, _e2029, (_e2029 < _e2005));
let _e2036 = global_5.member[bitcast<u32>(select(0i, _e2031, (_e2031 > 0i)))];
let _e2037 = bitcast<f32>(_e2036);
let _e2040 = local_26.member[3u];
let _e2041 = (_e1999 + _e2040);
let _e2043 = select(_e2005, _e2041, (_e2041 < _e2005));
let _e2048 = global_5.member[bitcast<u32>(select(0i, _e2043, (_e2043 > 0i)))];
let _e2050 = local_27[0u];
let _e2053 = (_e2013 + ((_e2025 - _e2013) * _e2050));
let _e2054 = local_27[0u];
let _e2057 = (_e2025 + ((_e2037 - _e2025) * _e2054));
let _e2058 = local_27[0u];
let _e2061 = (_e2037 + ((bitcast<f32>(_e2048) - _e2037) * _e2058));
let _e2062 = (_e1986 + _e1983);
let _e2063 = local_26.member[0u];
let _e2064 = (_e2062 + _e2063);
let _e2066 = select(_e2005, _e2064, (_e2064 < _e2005));
let _e2071 = global_5.member[bitcast<u32>(select(0i, _e2066, (_e2066 > 0i)))];
let _e2072 = bitcast<f32>(_e2071);
let _e2073 = local_26.member[1u];
let _e2074 = (_e2062 + _e2073);
let _e2076 = select(_e2005, _e2074, (_e2074 < _e2005));
let _e2081 = global_5.member[bitcast<u32>(select(0i, _e2076, (_e2076 > 0i)))];
let _e2082 = bitcast<f32>(_e2081);
let _e2083 = local_26.member[2u];
let _e2084 = (_e2062 + _e2083);
let _e2086 = select(_e2005, _e2084, (_e2084 < _e2005));
let _e2091 = global_5.member[bitcast<u32>(select(0i, _e2086, (_e2086 > 0i)))];
let _e2092 = bitcast<f32>(_e2091);
let _e2093 = local_26.member[3u];
let _e2094 = (_e2062 + _e2093);
let _e2096 = select(_e2005, _e2094, (_e2094 < _e2005));
let _e2101 = global_5.member[bitcast<u32>(select(0i, _e2096, (_e2096 > 0i)))];
let _e2103 = local_27[0u];
let _e2107 = local_27[0u];
let _e2110 = (_e2082 + ((_e2092 - _e2082) * _e2107));
let _e2111 = local_27[0u];
let _e2115 = (_e1987 + _e1982);
let _e2116 = local_26.member[0u];
let _e2117 = (_e2115 + _e2116);
let _e2119 = select(_e2005, _e2117, (_e2117 < _e2005));
let _e2124 = global_5.member[bitcast<u32>(select(0i, _e2119, (_e2119 > 0i)))];
let _e2125 = bitcast<f32>(_e2124);
let _e2126 = local_26.member[1u];
let _e2127 = (_e2115 + _e2126);
let _e2129 = select(_e2005, _e2127, (_e2127 < _e2005));
let _e2134 = global_5.member[bitcast<u32>(select(0i, _e2129, (_e2129 > 0i)))];
let _e2135 = bitcast<f32>(_e2134);
let _e2136 = local_26.member[2u];
let _e2137 = (_e2115 + _e2136);
let _e2139 = select(_e2005, _e2137, (_e2137 < _e2005));
let _e2144 = global_5.member[bitcast<u32>(select(0i, _e2139, (_e2139 > 0i)))];
let _e2145 = bitcast<f32>(_e2144);
let _e2146 = local_26.member[3u];
let _e2147 = (_e2115 + _e2146);
let _e2149 = select(_e2005, _e2147, (_e2147 < _e2005));
let _e2154 = global_5.member[bitcast<u32>(select(0i, _e2149, (_e2149 > 0i)))];
let _e2156 = local_27[0u];
let _e2159 = (_e2125 + ((_e2135 - _e2125) * _e2156));
let _e2160 = local_27[0u];
let _e2163 = (_e2135 + ((_e2145 - _e2135) * _e2160));
let _e2164 = local_27[0u];
let _e2167 = (_e2145 + ((bitcast<f32>(_e2154) - _e2145) * _e2164));
let _e2168 = (_e1987 + _e1983);
let _e2169 = local_26.member[0u];
let _e2170 = (_e2168 + _e2169);
let _e2172 = select(_e2005, _e2170, (_e2170 < _e2005));
let _e2177 = global_5.member[bitcast<u32>(select(0i, _e2172, (_e2172 > 0i)))];
let _e2178 = bitcast<f32>(_e2177);
let _e2179 = local_26.member[1u];
let _e2180 = (_e2168 + _e2179);
let _e2182 = select(_e2005, _e2180, (_e2180 < _e2005));
let _e2187 = global_5.member[bitcast<u32>(select(0i, _e2182, (_e2182 > 0i)))];
let _e2188 = bitcast<f32>(_e2187);
let _e2189 = local_26.member[2u];
let _e2190 = (_e2168 + _e2189);
let _e2192 = select(_e2005, _e2190, (_e2190 < _e2005));
let _e2197 = global_5.member[bitcast<u32>(select(0i, _e2192, (_e2192 > 0i)))];
let _e2198 = bitcast<f32>(_e2197);
let _e2199 = local_26.member[3u];
let _e2200 = (_e2168 + _e2199);
let _e2202 = select(_e2005, _e2200, (_e2200 < _e2005));
let _e2207 = global_5.member[bitcast<u32>(select(0i, _e2202, (_e2202 > 0i)))];
let _e2209 = local_27[0u];
let _e2213 = local_27[0u];
let _e2216 = (_e2188 + ((_e2198 - _e2188) * _e2213));
let _e2217 = local_27[0u];
let _e2221 = (_e1986 + _e1981);
let _e2222 = local_26.member[1u];
let _e2223 = (_e2221 + _e2222);
let _e2225 = select(_e2005, _e2223, (_e2223 < _e2005));
let _e2230 = global_5.member[bitcast<u32>(select(0i, _e2225, (_e2225 > 0i)))];
let _e2231 = bitcast<f32>(_e2230);
let _e2232 = local_26.member[2u];
let _e2233 = (_e2221 + _e2232);
let _e2235 = select(_e2005, _e2233, (_e2233 < _e2005));
let _e2240 = global_5.member[bitcast<u32>(select(0i, _e2235, (_e2235 > 0i)))];
let _e2242 = local_27[0u];
let _e2245 = (_e2231 + ((bitcast<f32>(_e2240) - _e2231) * _e2242));
let _e2246 = (_e1986 + _e1984);
let _e2247 = local_26.member[1u];
let _e2248 = (_e2246 + _e2247);
let _e2250 = select(_e2005, _e2248, (_e2248 < _e2005));
let _e2255 = global_5.member[bitcast<u32>(select(0i, _e2250, (_e2250 > 0i)))];
let _e2256 = bitcast<f32>(_e2255);
let _e2257 = local_26.member[2u];
let _e2258 = (_e2246 + _e2257);
let _e2260 = select(_e2005, _e2258, (_e2258 < _e2005));
let _e2265 = global_5.member[bitcast<u32>(select(0i, _e2260, (_e2260 > 0i)))];
let _e2267 = local_27[0u];
let _e2271 = (_e1987 + _e1981);
let _e2272 = local_26.member[1u];
let _e2273 = (_e2271 + _e2272);
let _e2275 = select(_e2005, _e2273, (_e2273 < _e2005));
let _e2280 = global_5.member[bitcast<u32>(select(0i, _e2275, (_e2275 > 0i)))];
let _e2281 = bitcast<f32>(_e2280);
let _e2282 = local_26.member[2u];
let _e2283 = (_e2271 + _e2282);
let _e2285 = select(_e2005, _e2283, (_e2283 < _e2005));
let _e2290 = global_5.member[bitcast<u32>(select(0i, _e2285, (_e2285 > 0i)))];
let _e2292 = local_27[0u];
let _e2295 = (_e2281 + ((bitcast<f32>(_e2290) - _e2281) * _e2292));
let _e2296 = (_e1987 + _e1984);
let _e2297 = local_26.member[1u];
let _e2298 = (_e2296 + _e2297);
let _e2300 = select(_e2005, _e2298, (_e2298 < _e2005));
let _e2305 = global_5.member[bitcast<u32>(select(0i, _e2300, (_e2300 > 0i)))];
let _e2306 = bitcast<f32>(_e2305);
let _e2307 = local_26.member[2u];
let _e2308 = (_e2296 + _e2307);
let _e2310 = select(_e2005, _e2308, (_e2308 < _e2005));
let _e2315 = global_5.member[bitcast<u32>(select(0i, _e2310, (_e2310 > 0i)))];
let _e2317 = local_27[0u];
let _e2321 = (_e1985 + _e1982);
let _e2322 = local_26.member[1u];
let _e2323 = (_e2321 + _e2322);
let _e2325 = select(_e2005, _e2323, (_e2323 < _e2005));
let _e2330 = global_5.member[bitcast<u32>(select(0i, _e2325, (_e2325 > 0i)))];
let _e2331 = bitcast<f32>(_e2330);
let _e2332 = local_26.member[2u];
let _e2333 = (_e2321 + _e2332);
let _e2335 = select(_e2005, _e2333, (_e2333 < _e2005));
let _e2340 = global_5.member[bitcast<u32>(select(0i, _e2335, (_e2335 > 0i)))];
let _e2342 = local_27[0u];
let _e2345 = (_e2331 + ((bitcast<f32>(_e2340) - _e2331) * _e2342));
let _e2346 = (_e1988 + _e1982);
let _e2347 = local_26.member[1u];
let _e2348 = (_e2346 + _e2347);
let _e2350 = select(_e2005, _e2348, (_e2348 < _e2005));
let _e2355 = global_5.member[bitcast<u32>(select(0i, _e2350, (_e2350 > 0i)))];
let _e2356 = bitcast<f32>(_e2355);
let _e2357 = local_26.member[2u];
let _e2358 = (_e2346 + _e2357);
let _e2360 = select(_e2005, _e2358, (_e2358 < _e2005));
let _e2365 = global_5.member[bitcast<u32>(select(0i, _e2360, (_e2360 > 0i)))];
let _e2367 = local_27[0u];
let _e2370 = (_e2356 + ((bitcast<f32>(_e2365) - _e2356) * _e2367));
let _e2371 = (_e1985 + _e1983);
let _e2372 = local_26.member[1u];
let _e2373 = (_e2371 + _e2372);
let _e2375 = select(_e2005, _e2373, (_e2373 < _e2005));
let _e2380 = global_5.member[bitcast<u32>(select(0i, _e2375, (_e2375 > 0i)))];
let _e2381 = bitcast<f32>(_e2380);
let _e2382 = local_26.member[2u];
let _e2383 = (_e2371 + _e2382);
let _e2385 = select(_e2005, _e2383, (_e2383 < _e2005));
let _e2390 = global_5.member[bitcast<u32>(select(0i, _e2385, (_e2385 > 0i)))];
let _e2392 = local_27[0u];
let _e2396 = (_e1988 + _e1983);
let _e2397 = local_26.member[1u];
let _e2398 = (_e2396 + _e2397);
let _e2400 = select(_e2005, _e2398, (_e2398 < _e2005));
let _e2405 = global_5.member[bitcast<u32>(select(0i, _e2400, (_e2400 > 0i)))];
let _e2406 = bitcast<f32>(_e2405);
let _e2407 = local_26.member[2u];
let _e2408 = (_e2396 + _e2407);
let _e2410 = select(_e2005, _e2408, (_e2408 < _e2005));
let _e2415 = global_5.member[bitcast<u32>(select(0i, _e2410, (_e2410 > 0i)))];
let _e2417 = local_27[0u];
let _e2422 = local_27[1u];
let _e2425 = (_e2057 + ((_e2110 - _e2057) * _e2422));
let _e2426 = local_27[1u];
let _e2429 = (_e2163 + ((_e2216 - _e2163) * _e2426));
let _e2430 = local_27[1u];
let _e2433 = (_e2053 + (((_e2072 + ((_e2082 - _e2072) * _e2103)) - _e2053) * _e2430));
let _e2434 = local_27[1u];
let _e2439 = local_27[2u];
let _e2443 = local_27[1u];
let _e2446 = (_e2061 + (((_e2092 + ((bitcast<f32>(_e2101) - _e2092) * _e2111)) - _e2061) * _e2443));
let _e2447 = local_27[1u];
let _e2451 = local_27[2u];
let _e2455 = local_27[1u];
let _e2458 = (_e2245 + ((_e2057 - _e2245) * _e2455));
let _e2459 = local_27[1u];
let _e2463 = local_27[2u];
let _e2467 = local_27[1u];
let _e2470 = (_e2110 + (((_e2256 + ((bitcast<f32>(_e2265) - _e2256) * _e2267)) - _e2110) * _e2467));
let _e2471 = local_27[1u];
let _e2475 = local_27[2u];
let _e2479 = local_27[1u];
let _e2482 = (_e2345 + (((_e2381 + ((bitcast<f32>(_e2390) - _e2381) * _e2392)) - _e2345) * _e2479));
let _e2483 = local_27[2u];
let _e2487 = local_27[1u];
let _e2491 = local_27[2u];
let _e2495 = local_27[2u];
let _e2502 = global_1.member.member_9.member_6;
let _e2506 = global_1.member.member_9.member_5;
let _e2508 = (((_e2425 + ((_e2429 - _e2425) * _e2495)) - _e2502) * _e2506);
let _e2510 = select(_e1836, _e2508, (_e2508 > _e1836));
let _e2514 = (((_e2433 + (((_e2159 + (((_e2178 + ((_e2188 - _e2178) * _e2209)) - _e2159) * _e2434)) - _e2433) * _e2439)) - _e2502) * _e2506);
let _e2516 = select(_e1836, _e2514, (_e2514 > _e1836));
let _e2518 = select(1e9f, _e2516, (_e2516 < 1e9f));
let _e2520 = (((_e2446 + (((_e2167 + (((_e2198 + ((bitcast<f32>(_e2207) - _e2198) * _e2217)) - _e2167) * _e2447)) - _e2446) * _e2451)) - _e2502) * _e2506);
let _e2522 = select(_e1836, _e2520, (_e2520 > _e1836));
let _e2524 = select(1e9f, _e2522, (_e2522 < 1e9f));
let _e2526 = (((_e2458 + (((_e2295 + ((_e2163 - _e2295) * _e2459)) - _e2458) * _e2463)) - _e2502) * _e2506);
let _e2528 = select(_e1836, _e2526, (_e2526 > _e1836));
let _e2530 = select(1e9f, _e2528, (_e2528 < 1e9f));
let _e2532 = (((_e2470 + (((_e2216 + (((_e2306 + ((bitcast<f32>(_e2315) - _e2306) * _e2317)) - _e2216) * _e2471)) - _e2470) * _e2475)) - _e2502) * _e2506);
let _e2534 = select(_e1836, _e2532, (_e2532 > _e1836));
let _e2536 = select(1e9f, _e2534, (_e2534 < 1e9f));
let _e2538 = (((_e2482 + ((_e2425 - _e2482) * _e2483)) - _e2502) * _e2506);
let _e2540 = select(_e1836, _e2538, (_e2538 > _e1836));
let _e2542 = select(1e9f, _e2540, (_e2540 < 1e9f));
let _e2544 = (((_e2429 + (((_e2370 + (((_e2406 + ((bitcast<f32>(_e2415) - _e2406) * _e2417)) - _e2370) * _e2487)) - _e2429) * _e2491)) - _e2502) * _e2506);
let _e2546 = select(_e1836, _e2544, (_e2544 > _e1836));
let _e2548 = select(1e9f, _e2546, (_e2546 < 1e9f));
local_24 = select(1e9f, _e2510, (_e2510 < 1e9f));
let _e2549 = local_24;
local_25 = _e2549;
let _e2550 = local_25;
let _e2552 = (bitcast<i32>(_e168) - 1i);
let _e2554 = select(_e2552, 263197i, (263197i < _e2552));
let _e2559 = global_3.member[bitcast<u32>(select(0i, _e2554, (_e2554 > 0i)))];
let _e2560 = bitcast<f32>(_e2559);
let _e2562 = select(_e2552, 263198i, (263198i < _e2552));
let _e2565 = bitcast<u32>(select(0i, _e2562, (_e2562 > 0i)));
let _e2567 = global_3.member[_e2565];
let _e2568 = bitcast<f32>(_e2567);
let _e2570 = select(_e2552, 263199i, (263199i < _e2552));
let _e2575 = global_3.member[bitcast<u32>(select(0i, _e2570, (_e2570 > 0i)))];
let _e2576 = bitcast<f32>(_e2575);
let _e2578 = ((_e2550 - _e2560) * _e2568);
let _e2580 = select(0f, _e2578, (_e2578 > 0f));
let _e2583 = local_25;
let _e2585 = select(_e2552, 263200i, (263200i < _e2552));
let _e2590 = global_3.member[bitcast<u32>(select(0i, _e2585, (_e2585 > 0i)))];
let _e2591 = bitcast<f32>(_e2590);
let _e2593 = select(_e2552, 263201i, (263201i < _e2552));
let _e2598 = global_3.member[bitcast<u32>(select(0i, _e2593, (_e2593 > 0i)))];
let _e2599 = bitcast<f32>(_e2598);
let _e2601 = select(_e2552, 263202i, (263202i < _e2552));
let _e2606 = global_3.member[bitcast<u32>(select(0i, _e2601, (_e2601 > 0i)))];
let _e2607 = bitcast<f32>(_e2606);
let _e2609 = ((_e2583 - _e2591) * _e2599);
let _e2611 = select(0f, _e2609, (_e2609 > 0f));
let _e2615 = local_25;
let _e2617 = select(_e2552, 263203i, (263203i < _e2552));
let _e2622 = global_3.member[bitcast<u32>(select(0i, _e2617, (_e2617 > 0i)))];
let _e2623 = bitcast<f32>(_e2622);
let _e2625 = select(_e2552, 263204i, (263204i < _e2552));
let _e2630 = global_3.member[bitcast<u32>(select(0i, _e2625, (_e2625 > 0i)))];
let _e2631 = bitcast<f32>(_e2630);
let _e2633 = select(_e2552, 263205i, (263205i < _e2552));
let _e2638 = global_3.member[bitcast<u32>(select(0i, _e2633, (_e2633 > 0i)))];
let _e2639 = bitcast<f32>(_e2638);
let _e2641 = ((_e2615 - _e2623) * _e2631);
let _e2643 = select(0f, _e2641, (_e2641 > 0f));
let _e2646 = local_25;
let _e2648 = select(_e2552, 263206i, (263206i < _e2552));
let _e2653 = global_3.member[bitcast<u32>(select(0i, _e2648, (_e2648 > 0i)))];
let _e2654 = bitcast<f32>(_e2653);
let _e2656 = select(_e2552, 263207i, (263207i < _e2552));
let _e2661 = global_3.member[bitcast<u32>(select(0i, _e2656, (_e2656 > 0i)))];
let _e2662 = bitcast<f32>(_e2661);
let _e2664 = select(_e2552, 263208i, (263208i < _e2552));
let _e2669 = global_3.member[bitcast<u32>(select(0i, _e2664, (_e2664 > 0i)))];
let _e2670 = bitcast<f32>(_e2669);
let _e2672 = ((_e2646 - _e2654) * _e2662);
let _e2674 = select(0f, _e2672, (_e2672 > 0f));
let _e2678 = ((select(_e2576, _e2580, (_e2580 < _e2576)) + select(_e2607, _e2611, (_e2611 < _e2607))) + (select(_e2639, _e2643, (_e2643 < _e2639)) + select(_e2670, _e2674, (_e2674 < _e2670))));
let _e2680 = select(0f, _e2678, (_e2678 > 0f));
let _e2682 = select(1023f, _e2680, (_e2680 < 1023f));
let _e2689 = select(0i, select(select(i32(_e2682), i32(-2147483648), (_e2682 < -2147483600f)), 2147483647i, (_e2682 > 2147483500f)), (_e2682 == _e2682));
let _e2693 = (_e2689 - select(0i, 1i, (_e2682 < f32(_e2689))));
let _e2694 = (262147i + _e2693);
let _e2696 = select(_e2552, _e2694, (_e2694 < _e2552));
let _e2702 = global_3.member[bitcast<u32>(select(0i, _e2696, (_e2696 > 0i)))];
let _e2712 = select(_e2552, 262146i, (262146i < _e2552));
let _e2718 = global_3.member[bitcast<u32>(select(0i, _e2712, (_e2712 > 0i)))];
let _e2719 = bitcast<f32>(_e2718);
let _e2720 = (f32((bitcast<i32>((_e2702 & 4095u)) - 2048i)) * _e2719);
let _e2722 = select(_e2552, 262144i, (262144i < _e2552));
let _e2728 = global_3.member[bitcast<u32>(select(0i, _e2722, (_e2722 > 0i)))];
let _e2729 = bitcast<f32>(_e2728);
let _e2731 = select(_e2552, 262145i, (262145i < _e2552));
let _e2737 = global_3.member[bitcast<u32>(select(0i, _e2731, (_e2731 > 0i)))];
let _e2738 = bitcast<f32>(_e2737);
let _e2744 = ((_e2729 + (f32(bitcast<i32>((_e2702 >> bitcast<u32>(12u)))) * _e2738)) + (_e2720 * (_e2678 - f32(_e2693))));
let _e2747 = global_3.member[_e2565];
let _e2749 = local_24;
let _e2752 = local_24;
let _e2755 = local_24;
let _e2759 = select(_e2552, 263209i, (263209i < _e2552));
let _e2765 = global_3.member[bitcast<u32>(select(0i, _e2759, (_e2759 > 0i)))];
let _e2767 = local_24;
let _e2770 = select(_e2552, 263210i, (263210i < _e2552));
let _e2776 = global_3.member[bitcast<u32>(select(0i, _e2770, (_e2770 > 0i)))];
let _e2778 = local_24;
let _e2782 = (_e2720 * select(0f, select(select(select(bitcast<f32>(_e2747), _e2599, (_e2749 >= _e2591)), _e2631, (_e2752 >= _e2623)), _e2662, (_e2755 >= _e2654)), ((_e2767 >= bitcast<f32>(_e2765)) && (_e2778 <= bitcast<f32>(_e2776)))));
if _e1562 {
let _e2789 = ((0.5f * (_e2524 - _e2518)) * _e2782);
let _e2790 = ((0.5f * (_e2536 - _e2530)) * _e2782);
let _e2791 = ((0.5f * (_e2548 - _e2542)) * _e2782);
phi_8609_ = type_32(_e2744, vec3<f32>(_e2789, _e2790, _e2791), vec3<f32>((_e2789 * _e2744), (_e2790 * _e2744), (_e2791 * _e2744)));
} else {
local_22 = _e2518;
let _e2798 = local_22;
local_23 = _e2798;
let _e2799 = local_23;
let _e2801 = ((_e2799 - _e2560) * _e2568);
let _e2803 = select(0f, _e2801, (_e2801 > 0f));
let _e2806 = local_23;
let _e2808 = ((_e2806 - _e2591) * _e2599);
let _e2810 = select(0f, _e2808, (_e2808 > 0f));
let _e2814 = local_23;
let _e2816 = ((_e2814 - _e2623) * _e2631);
let _e2818 = select(0f, _e2816, (_e2816 > 0f));
let _e2821 = local_23;
let _e2823 = ((_e2821 - _e2654) * _e2662);
let _e2825 = select(0f, _e2823, (_e2823 > 0f));
let _e2829 = ((select(_e2576, _e2803, (_e2803 < _e2576)) + select(_e2607, _e2810, (_e2810 < _e2607))) + (select(_e2639, _e2818, (_e2818 < _e2639)) + select(_e2670, _e2825, (_e2825 < _e2670))));
let _e2831 = select(0f, _e2829, (_e2829 > 0f));
let _e2833 = select(1023f, _e2831, (_e2831 < 1023f));
let _e2840 = select(0i, select(select(i32(_e2833), i32(-2147483648), (_e2833 < -2147483600f)), 2147483647i, (_e2833 > 2147483500f)), (_e2833 == _e2833));
let _e2844 = (_e2840 - select(0i, 1i, (_e2833 < f32(_e2840))));
let _e2845 = (262147i + _e2844);
let _e2847 = select(_e2552, _e2845, (_e2845 < _e2552));
let _e2853 = global_3.member[bitcast<u32>(select(0i, _e2847, (_e2847 > 0i)))];
let _e2868 = ((_e2729 + (f32(bitcast<i32>((_e2853 >> bitcast<u32>(12u)))) * _e2738)) + ((f32((bitcast<i32>((_e2853 & 4095u)) - 2048i)) * _e2719) * (_e2829 - f32(_e2844))));
local_20 = _e2524;
let _e2869 = local_20;
local_21 = _e2869;
let _e2870 = local_21;
let _e2872 = ((_e2870 - _e2560) * _e2568);
let _e2874 = select(0f, _e2872, (_e2872 > 0f));
let _e2877 = local_21;
let _e2879 = ((_e2877 - _e2591) * _e2599);
let _e2881 = select(0f, _e2879, (_e2879 > 0f));
let _e2885 = local_21;
let _e2887 = ((_e2885 - _e2623) * _e2631);
let _e2889 = select(0f, _e2887, (_e2887 > 0f));
let _e2892 = local_21;
let _e2894 = ((_e2892 - _e2654) * _e2662);
let _e2896 = select(0f, _e2894, (_e2894 > 0f));
let _e2900 = ((select(_e2576, _e2874, (_e2874 < _e2576)) + select(_e2607, _e2881, (_e2881 < _e2607))) + (select(_e2639, _e2889, (_e2889 < _e2639)) + select(_e2670, _e2896, (_e2896 < _e2670))));
let _e2902 = select(0f, _e2900, (_e2900 > 0f));
let _e2904 = select(1023f, _e2902, (_e2902 < 1023f));
let _e2911 = select(0i, select(select(i32(_e2904), i32(-2147483648), (_e2904 < -2147483600f)), 2147483647i, (_e2904 > 2147483500f)), (_e2904 == _e2904));
let _e2915 = (_e2911 - select(0i, 1i, (_e2904 < f32(_e2911))));
let _e2916 = (262147i + _e2915);
let _e2918 = select(_e2552, _e2916, (_e2916 < _e2552));
let _e2924 = global_3.member[bitcast<u32>(select(0i, _e2918, (_e2918 > 0i)))];
let _e2939 = ((_e2729 + (f32(bitcast<i32>((_e2924 >> bitcast<u32>(12u)))) * _e2738)) + ((f32((bitcast<i32>((_e2924 & 4095u)) - 2048i)) * _e2719) * (_e2900 - f32(_e2915))));
local_18 = _e2530;
let _e2940 = local_18;
local_19 = _e2940;
let _e2941 = local_19;
let _e2943 = ((_e2941 - _e2560) * _e2568);
let _e2945 = select(0f, _e2943, (_e2943 > 0f));
let _e2948 = local_19;
let _e2950 = ((_e2948 - _e2591) * _e2599);
let _e2952 = select(0f, _e2950, (_e2950 > 0f));
let _e2956 = local_19;
let _e2958 = ((_e2956 - _e2623) * _e2631);
let _e2960 = select(0f, _e2958, (_e2958 > 0f));
let _e2963 = local_19;
let _e2965 = ((_e2963 - _e2654) * _e2662);
let _e2967 = select(0f, _e2965, (_e2965 > 0f));
let _e2971 = ((select(_e2576, _e2945, (_e2945 < _e2576)) + select(_e2607, _e2952, (_e2952 < _e2607))) + (select(_e2639, _e2960, (_e2960 < _e2639)) + select(_e2670, _e2967, (_e2967 < _e2670))));
let _e2973 = select(0f, _e2971, (_e2971 > 0f));
let _e2975 = select(1023f, _e2973, (_e2973 < 1023f));
let _e2982 = select(0i, select(select(i32(_e2975), i32(-2147483648), (_e2975 < -2147483600f)), 2147483647i, (_e2975 > 2147483500f)), (_e2975 == _e2975));
let _e2986 = (_e2982 - select(0i, 1i, (_e2975 < f32(_e2982))));
let _e2987 = (262147i + _e2986);
let _e2989 = select(_e2552, _e2987, (_e2987 < _e2552));
let _e2995 = global_3.member[bitcast<u32>(select(0i, _e2989, (_e2989 > 0i)))];
let _e3010 = ((_e2729 + (f32(bitcast<i32>((_e2995 >> bitcast<u32>(12u)))) * _e2738)) + ((f32((bitcast<i32>((_e2995 & 4095u)) - 2048i)) * _e2719) * (_e2971 - f32(_e2986))));
local_16 = _e2536;
let _e3011 = local_16;
local_17 = _e3011;
let _e3012 = local_17;
let _e3014 = ((_e3012 - _e2560) * _e2568);
let _e3016 = select(0f, _e3014, (_e3014 > 0f));
let _e3019 = local_17;
let _e3021 = ((_e3019 - _e2591) * _e2599);
let _e3023 = select(0f, _e3021, (_e3021 > 0f));
let _e3027 = local_17;
let _e3029 = ((_e3027 - _e2623) * _e2631);
let _e3031 = select(0f, _e3029, (_e3029 > 0f));
let _e3034 = local_17;
let _e3036 = ((_e3034 - _e2654) * _e2662);
let _e3038 = select(0f, _e3036, (_e3036 > 0f));
let _e3042 = ((select(_e2576, _e3016, (_e3016 < _e2576)) + select(_e2607, _e3023, (_e3023 < _e2607))) + (select(_e2639, _e3031, (_e3031 < _e2639)) + select(_e2670, _e3038, (_e3038 < _e2670))));
let _e3044 = select(0f, _e3042, (_e3042 > 0f));
let _e3046 = select(1023f, _e3044, (_e3044 < 1023f));
let _e3053 = select(0i, select(select(i32(_e3046), i32(-2147483648), (_e3046 < -2147483600f)), 2147483647i, (_e3046 > 2147483500f)), (_e3046 == _e3046));
let _e3057 = (_e3053 - select(0i, 1i, (_e3046 < f32(_e3053))));
let _e3058 = (262147i + _e3057);
let _e3060 = select(_e2552, _e3058, (_e3058 < _e2552));
let _e3066 = global_3.member[bitcast<u32>(select(0i, _e3060, (_e3060 > 0i)))];
let _e3081 = ((_e2729 + (f32(bitcast<i32>((_e3066 >> bitcast<u32>(12u)))) * _e2738)) + ((f32((bitcast<i32>((_e3066 & 4095u)) - 2048i)) * _e2719) * (_e3042 - f32(_e3057))));
local_14 = _e2542;
let _e3082 = local_14;
local_15 = _e3082;
let _e3083 = local_15;
let _e3085 = ((_e3083 - _e2560) * _e2568);
let _e3087 = select(0f, _e3085, (_e3085 > 0f));
let _e3090 = local_15;
let _e3092 = ((_e3090 - _e2591) * _e2599);
let _e3094 = select(0f, _e3092, (_e3092 > 0f));
let _e3098 = local_15;
let _e3100 = ((_e3098 - _e2623) * _e2631);
let _e3102 = select(0f, _e3100, (_e3100 > 0f));
let _e3105 = local_15;
let _e3107 = ((_e3105 - _e2654) * _e2662);
let _e3109 = select(0f, _e3107, (_e3107 > 0f));
let _e3113 = ((select(_e2576, _e3087, (_e3087 < _e2576)) + select(_e2607, _e3094, (_e3094 < _e2607))) + (select(_e2639, _e3102, (_e3102 < _e2639)) + select(_e2670, _e3109, (_e3109 < _e2670))));
let _e3115 = select(0f, _e3113, (_e3113 > 0f));
let _e3117 = select(1023f, _e3115, (_e3115 < 1023f));
let _e3124 = select(0i, select(select(i32(_e3117), i32(-2147483648), (_e3117 < -2147483600f)), 2147483647i, (_e3117 > 2147483500f)), (_e3117 == _e3117));
let _e3128 = (_e3124 - select(0i, 1i, (_e3117 < f32(_e3124))));
let _e3129 = (262147i + _e3128);
let _e3131 = select(_e2552, _e3129, (_e3129 < _e2552));
let _e3137 = global_3.member[bitcast<u32>(select(0i, _e3131, (_e3131 > 0i)))];
let _e3152 = ((_e2729 + (f32(bitcast<i32>((_e3137 >> bitcast<u32>(12u)))) * _e2738)) + ((f32((bitcast<i32>((_e3137 & 4095u)) - 2048i)) * _e2719) * (_e3113 - f32(_e3128))));
local_12 = _e2548;
let _e3153 = local_12;
local_13 = _e3153;
let _e3154 = local_13;
let _e3156 = ((_e3154 - _e2560) * _e2568);
let _e3158 = select(0f, _e3156, (_e3156 > 0f));
let _e3161 = local_13;
let _e3163 = ((_e3161 - _e2591) * _e2599);
let _e3165 = select(0f, _e3163, (_e3163 > 0f));
let _e3169 = local_13;
let _e3171 = ((_e3169 - _e2623) * _e2631);
let _e3173 = select(0f, _e3171, (_e3171 > 0f));
let _e3176 = local_13;
let _e3178 = ((_e3176 - _e2654) * _e2662);
let _e3180 = select(0f, _e3178, (_e3178 > 0f));
let _e3184 = ((select(_e2576, _e3158, (_e3158 < _e2576)) + select(_e2607, _e3165, (_e3165 < _e2607))) + (select(_e2639, _e3173, (_e3173 < _e2639)) + select(_e2670, _e3180, (_e3180 < _e2670))));
let _e3186 = select(0f, _e3184, (_e3184 > 0f));
let _e3188 = select(1023f, _e3186, (_e3186 < 1023f));
let _e3195 = select(0i, select(select(i32(_e3188), i32(-2147483648), (_e3188 < -2147483600f)), 2147483647i, (_e3188 > 2147483500f)), (_e3188 == _e3188));
let _e3199 = (_e3195 - select(0i, 1i, (_e3188 < f32(_e3195))));
let _e3200 = (262147i + _e3199);
let _e3202 = select(_e2552, _e3200, (_e3200 < _e2552));
let _e3208 = global_3.member[bitcast<u32>(select(0i, _e3202, (_e3202 > 0i)))];
let _e3223 = ((_e2729 + (f32(bitcast<i32>((_e3208 >> bitcast<u32>(12u)))) * _e2738)) + ((f32((bitcast<i32>((_e3208 & 4095u)) - 2048i)) * _e2719) * (_e3184 - f32(_e3199))));
let _e3224 = (_e2939 - _e2868);
let _e3226 = (_e3081 - _e3010);
let _e3228 = (_e3223 - _e3152);
phi_8609_ = type_32(_e2744, vec3<f32>((0.5f * _e3224), (0.5f * _e3226), (0.5f * _e3228)), vec3<f32>((0.25f * (_e3224 * (_e2939 + _e2868))), (0.25f * (_e3226 * (_e3081 + _e3010))), (0.25f * (_e3228 * (_e3223 + _e3152)))));
}
let _e3243 = phi_8609_;
let _e3258 = select(0f, 1f, ((((((_e1524 >= -0.5f) && (_e1524 <= _e1846)) && (_e1539 >= -0.5f)) && (_e1539 <= _e1856)) && (_e1554 >= -0.5f)) && (_e1554 <= _e1866)));
let _e3260 = (0.5f * (_e2524 - _e2518));
let _e3262 = (0.5f * (_e2536 - _e2530));
let _e3264 = (0.5f * (_e2548 - _e2542));
let _e3270 = global_1.member.member_9.member.member.member;
let _e3276 = global_1.member.member_9.member.member.member_1;
let _e3282 = global_1.member.member_9.member.member.member_2;
let _e3288 = global_1.member.member_9.member_1.member.member;
let _e3294 = global_1.member.member_9.member_1.member.member_1;
let _e3300 = global_1.member.member_9.member_1.member.member_2;
let _e3306 = global_1.member.member_9.member_2.member.member;
let _e3312 = global_1.member.member_9.member_2.member.member_1;
let _e3318 = global_1.member.member_9.member_2.member.member_2;
phi_9256_ = type_33(select(1e9f, _e1838, (_e1838 < 1e9f)), vec3<f32>(((((_e3270 * _e3260) + (_e3288 * _e3262)) + (_e3306 * _e3264)) * _e3258), ((((_e3276 * _e3260) + (_e3294 * _e3262)) + (_e3312 * _e3264)) * _e3258), ((((_e3282 * _e3260) + (_e3300 * _e3262)) + (_e3318 * _e3264)) * _e3258)), _e3243.member, vec3<f32>(((((_e3270 * _e3243.member_2.x) + (_e3288 * _e3243.member_2.y)) + (_e3306 * _e3243.member_2.z)) * _e3258), ((((_e3276 * _e3243.member_2.x) + (_e3294 * _e3243.member_2.y)) + (_e3312 * _e3243.member_2.z)) * _e3258), ((((_e3282 * _e3243.member_2.x) + (_e3300 * _e3243.member_2.y)) + (_e3318 * _e3243.member_2.z)) * _e3258)), vec3<f32>(((((_e3270 * _e3243.member_1.x) + (_e3288 * _e3243.member_1.y)) + (_e3306 * _e3243.member_1.z)) * _e3258), ((((_e3276 * _e3243.member_1.x) + (_e3294 * _e3243.member_1.y)) + (_e3312 * _e3243.member_1.z)) * _e3258), ((((_e3282 * _e3243.member_1.x) + (_e3300 * _e3243.member_1.y)) + (_e3318 * _e3243.member_1.z)) * _e3258)));
} else {
let _e3387 = global_1.member.member_8.member_3.member;
let _e3388 = (_e3387 - 0.5f);
let _e3390 = select(-0.5f, _e1497, (_e1497 > -0.5f));
let _e3392 = select(_e3388, _e3390, (_e3390 < _e3388));
let _e3397 = global_1.member.member_8.member_3.member_1;
let _e3398 = (_e3397 - 0.5f);
let _e3400 = select(-0.5f, _e1503, (_e1503 > -0.5f));
let _e3402 = select(_e3398, _e3400, (_e3400 < _e3398));
let _e3407 = global_1.member.member_8.member_3.member_2;
let _e3408 = (_e3407 - 0.5f);
let _e3410 = select(-0.5f, _e1509, (_e1509 > -0.5f));
let _e3412 = select(_e3408, _e3410, (_e3410 < _e3408));
let _e3414 = select(-1f, _e3392, (_e3392 > -1f));
let _e3416 = select(_e3387, _e3414, (_e3414 < _e3387));
let _e3423 = select(0i, select(select(i32(_e3416), i32(-2147483648), (_e3416 < -2147483600f)), 2147483647i, (_e3416 > 2147483500f)), (_e3416 == _e3416));
let _e3427 = (_e3423 - select(0i, 1i, (_e3416 < f32(_e3423))));
let _e3429 = select(-1f, _e3402, (_e3402 > -1f));
let _e3431 = select(_e3397, _e3429, (_e3429 < _e3397));
let _e3438 = select(0i, select(select(i32(_e3431), i32(-2147483648), (_e3431 < -2147483600f)), 2147483647i, (_e3431 > 2147483500f)), (_e3431 == _e3431));
let _e3442 = (_e3438 - select(0i, 1i, (_e3431 < f32(_e3438))));
let _e3444 = select(-1f, _e3412, (_e3412 > -1f));
let _e3446 = select(_e3407, _e3444, (_e3444 < _e3407));
let _e3453 = select(0i, select(select(i32(_e3446), i32(-2147483648), (_e3446 < -2147483600f)), 2147483647i, (_e3446 > 2147483500f)), (_e3446 == _e3446));
let _e3457 = (_e3453 - select(0i, 1i, (_e3446 < f32(_e3453))));
let _e3461 = global_1.member.member_8.member_7;
let _e3465 = global_1.member.member_8.member_8;
let _e3473 = (select(0i, select(select(i32(_e3397), i32(-2147483648), (_e3397 < -2147483600f)), 2147483647i, (_e3397 > 2147483500f)), (_e3397 == _e3397)) - 1i);
let _e3476 = (_e3442 + 1i);
let _e3486 = (select(0i, select(select(i32(_e3407), i32(-2147483648), (_e3407 < -2147483600f)), 2147483647i, (_e3407 > 2147483500f)), (_e3407 == _e3407)) - 1i);
let _e3489 = (_e3457 + 1i);
let _e3499 = (select(0i, select(select(i32(_e3387), i32(-2147483648), (_e3387 < -2147483600f)), 2147483647i, (_e3387 > 2147483500f)), (_e3387 == _e3387)) - 1i);
let _e3500 = (_e3427 - 1i);
let _e3505 = (_e3427 + 1i);
let _e3508 = (_e3427 + 2i);
let _e3511 = (select(0i, _e3442, (_e3442 > 0i)) * _e3461);
let _e3512 = (select(_e3473, _e3476, (_e3476 < _e3473)) * _e3461);
let _e3513 = (select(0i, _e3457, (_e3457 > 0i)) * _e3465);
let _e3514 = (select(_e3486, _e3489, (_e3489 < _e3486)) * _e3465);
local_10 = type_29(array<i32, 4>(select(0i, _e3500, (_e3500 > 0i)), select(0i, _e3427, (_e3427 > 0i)), select(_e3499, _e3505, (_e3505 < _e3499)), select(_e3499, _e3508, (_e3508 < _e3499))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_11 = vec3<f32>((_e3392 - f32(_e3427)), (_e3402 - f32(_e3442)), (_e3412 - f32(_e3457)));
let _e3525 = (_e3513 + _e3511);
let _e3528 = local_10.member[1u];
let _e3529 = (_e3525 + _e3528);
let _e3531 = (bitcast<i32>(_e160) - 1i);
let _e3533 = select(_e3531, _e3529, (_e3529 < _e3531));
let _e3538 = global_2.member[bitcast<u32>(select(0i, _e3533, (_e3533 > 0i)))];
let _e3539 = bitcast<f32>(_e3538);
let _e3542 = local_10.member[2u];
let _e3543 = (_e3525 + _e3542);
let _e3545 = select(_e3531, _e3543, (_e3543 < _e3531));
let _e3550 = global_2.member[bitcast<u32>(select(0i, _e3545, (_e3545 > 0i)))];
let _e3552 = local_11[0u];
let _e3555 = (_e3539 + ((bitcast<f32>(_e3550) - _e3539) * _e3552));
let _e3556 = (_e3513 + _e3512);
let _e3557 = local_10.member[1u];
let _e3558 = (_e3556 + _e3557);
let _e3560 = select(_e3531, _e3558, (_e3558 < _e3531));
let _e3565 = global_2.member[bitcast<u32>(select(0i, _e3560, (_e3560 > 0i)))];
let _e3566 = bitcast<f32>(_e3565);
let _e3567 = local_10.member[2u];
let _e3568 = (_e3556 + _e3567);
let _e3570 = select(_e3531, _e3568, (_e3568 < _e3531));
let _e3575 = global_2.member[bitcast<u32>(select(0i, _e3570, (_e3570 > 0i)))];
let _e3577 = local_11[0u];
let _e3582 = local_11[1u];
let _e3585 = (_e3555 + (((_e3566 + ((bitcast<f32>(_e3575) - _e3566) * _e3577)) - _e3555) * _e3582));
let _e3586 = (_e3514 + _e3511);
let _e3587 = local_10.member[1u];
let _e3588 = (_e3586 + _e3587);
let _e3590 = select(_e3531, _e3588, (_e3588 < _e3531));
let _e3595 = global_2.member[bitcast<u32>(select(0i, _e3590, (_e3590 > 0i)))];
let _e3596 = bitcast<f32>(_e3595);
let _e3597 = local_10.member[2u];
let _e3598 = (_e3586 + _e3597);
let _e3600 = select(_e3531, _e3598, (_e3598 < _e3531));
let _e3605 = global_2.member[bitcast<u32>(select(0i, _e3600, (_e3600 > 0i)))];
let _e3607 = local_11[0u];
let _e3610 = (_e3596 + ((bitcast<f32>(_e3605) - _e3596) * _e3607));
let _e3611 = (_e3514 + _e3512);
let _e3612 = local_10.member[1u];
let _e3613 = (_e3611 + _e3612);
let _e3615 = select(_e3531, _e3613, (_e3613 < _e3531));
let _e3620 = global_2.member[bitcast<u32>(select(0i, _e3615, (_e3615 > 0i)))];
let _e3621 = bitcast<f32>(_e3620);
let _e3622 = local_10.member[2u];
let _e3623 = (_e3611 + _e3622);
let _e3625 = select(_e3531, _e3623, (_e3623 < _e3531));
let _e3630 = global_2.member[bitcast<u32>(select(0i, _e3625, (_e3625 > 0i)))];
let _e3632 = local_11[0u];
let _e3636 = local_11[1u];
let _e3641 = local_11[2u];
let _e3648 = global_1.member.member_8.member_6;
let _e3652 = global_1.member.member_8.member_5;
let _e3654 = (((_e3585 + (((_e3610 + (((_e3621 + ((bitcast<f32>(_e3630) - _e3621) * _e3632)) - _e3610) * _e3636)) - _e3585) * _e3641)) - _e3648) * _e3652);
let _e3655 = -(1e9f);
let _e3657 = select(_e3655, _e3654, (_e3654 > _e3655));
phi_9256_ = type_33(select(1e9f, _e3657, (_e3657 < 1e9f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e3662 = phi_9256_;
let _e3667 = global_1.member.member_8.member_3.member;
let _e3668 = (_e3667 - 0.5f);
let _e3670 = select(-0.5f, _e1461, (_e1461 > -0.5f));
let _e3672 = select(_e3668, _e3670, (_e3670 < _e3668));
let _e3677 = global_1.member.member_8.member_3.member_1;
let _e3678 = (_e3677 - 0.5f);
let _e3680 = select(-0.5f, _e1476, (_e1476 > -0.5f));
let _e3682 = select(_e3678, _e3680, (_e3680 < _e3678));
let _e3687 = global_1.member.member_8.member_3.member_2;
let _e3688 = (_e3687 - 0.5f);
let _e3690 = select(-0.5f, _e1491, (_e1491 > -0.5f));
let _e3692 = select(_e3688, _e3690, (_e3690 < _e3688));
let _e3694 = select(-1f, _e3672, (_e3672 > -1f));
let _e3696 = select(_e3667, _e3694, (_e3694 < _e3667));
let _e3703 = select(0i, select(select(i32(_e3696), i32(-2147483648), (_e3696 < -2147483600f)), 2147483647i, (_e3696 > 2147483500f)), (_e3696 == _e3696));
let _e3707 = (_e3703 - select(0i, 1i, (_e3696 < f32(_e3703))));
let _e3709 = select(-1f, _e3682, (_e3682 > -1f));
let _e3711 = select(_e3677, _e3709, (_e3709 < _e3677));
let _e3718 = select(0i, select(select(i32(_e3711), i32(-2147483648), (_e3711 < -2147483600f)), 2147483647i, (_e3711 > 2147483500f)), (_e3711 == _e3711));
let _e3722 = (_e3718 - select(0i, 1i, (_e3711 < f32(_e3718))));
let _e3724 = select(-1f, _e3692, (_e3692 > -1f));
let _e3726 = select(_e3687, _e3724, (_e3724 < _e3687));
let _e3733 = select(0i, select(select(i32(_e3726), i32(-2147483648), (_e3726 < -2147483600f)), 2147483647i, (_e3726 > 2147483500f)), (_e3726 == _e3726));
let _e3737 = (_e3733 - select(0i, 1i, (_e3726 < f32(_e3733))));
let _e3741 = global_1.member.member_8.member_7;
let _e3745 = global_1.member.member_8.member_8;
let _e3753 = (select(0i, select(select(i32(_e3677), i32(-2147483648), (_e3677 < -2147483600f)), 2147483647i, (_e3677 > 2147483500f)), (_e3677 == _e3677)) - 1i);
let _e3756 = (_e3722 + 1i);
let _e3766 = (select(0i, select(select(i32(_e3687), i32(-2147483648), (_e3687 < -2147483600f)), 2147483647i, (_e3687 > 2147483500f)), (_e3687 == _e3687)) - 1i);
let _e3769 = (_e3737 + 1i);
let _e3779 = (select(0i, select(select(i32(_e3667), i32(-2147483648), (_e3667 < -2147483600f)), 2147483647i, (_e3667 > 2147483500f)), (_e3667 == _e3667)) - 1i);
let _e3780 = (_e3707 - 1i);
let _e3785 = (_e3707 + 1i);
let _e3788 = (_e3707 + 2i);
let _e3791 = (select(0i, _e3722, (_e3722 > 0i)) * _e3741);
let _e3792 = (select(_e3753, _e3756, (_e3756 < _e3753)) * _e3741);
let _e3793 = (select(0i, _e3737, (_e3737 > 0i)) * _e3745);
let _e3794 = (select(_e3766, _e3769, (_e3769 < _e3766)) * _e3745);
local_8 = type_29(array<i32, 4>(select(0i, _e3780, (_e3780 > 0i)), select(0i, _e3707, (_e3707 > 0i)), select(_e3779, _e3785, (_e3785 < _e3779)), select(_e3779, _e3788, (_e3788 < _e3779))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_9 = vec3<f32>((_e3672 - f32(_e3707)), (_e3682 - f32(_e3722)), (_e3692 - f32(_e3737)));
let _e3805 = (_e3793 + _e3791);
let _e3808 = local_8.member[1u];
let _e3809 = (_e3805 + _e3808);
let _e3811 = (bitcast<i32>(_e160) - 1i);
let _e3813 = select(_e3811, _e3809, (_e3809 < _e3811));
let _e3818 = global_2.member[bitcast<u32>(select(0i, _e3813, (_e3813 > 0i)))];
let _e3819 = bitcast<f32>(_e3818);
let _e3822 = local_8.member[2u];
let _e3823 = (_e3805 + _e3822);
let _e3825 = select(_e3811, _e3823, (_e3823 < _e3811));
let _e3830 = global_2.member[bitcast<u32>(select(0i, _e3825, (_e3825 > 0i)))];
let _e3832 = local_9[0u];
let _e3835 = (_e3819 + ((bitcast<f32>(_e3830) - _e3819) * _e3832));
let _e3836 = (_e3793 + _e3792);
let _e3837 = local_8.member[1u];
let _e3838 = (_e3836 + _e3837);
let _e3840 = select(_e3811, _e3838, (_e3838 < _e3811));
let _e3845 = global_2.member[bitcast<u32>(select(0i, _e3840, (_e3840 > 0i)))];
let _e3846 = bitcast<f32>(_e3845);
let _e3847 = local_8.member[2u];
let _e3848 = (_e3836 + _e3847);
let _e3850 = select(_e3811, _e3848, (_e3848 < _e3811));
let _e3855 = global_2.member[bitcast<u32>(select(0i, _e3850, (_e3850 > 0i)))];
let _e3857 = local_9[0u];
let _e3862 = local_9[1u];
let _e3865 = (_e3835 + (((_e3846 + ((bitcast<f32>(_e3855) - _e3846) * _e3857)) - _e3835) * _e3862));
let _e3866 = (_e3794 + _e3791);
let _e3867 = local_8.member[1u];
let _e3868 = (_e3866 + _e3867);
let _e3870 = select(_e3811, _e3868, (_e3868 < _e3811));
let _e3875 = global_2.member[bitcast<u32>(select(0i, _e3870, (_e3870 > 0i)))];
let _e3876 = bitcast<f32>(_e3875);
let _e3877 = local_8.member[2u];
let _e3878 = (_e3866 + _e3877);
let _e3880 = select(_e3811, _e3878, (_e3878 < _e3811));
let _e3885 = global_2.member[bitcast<u32>(select(0i, _e3880, (_e3880 > 0i)))];
let _e3887 = local_9[0u];
let _e3890 = (_e3876 + ((bitcast<f32>(_e3885) - _e3876) * _e3887));
let _e3891 = (_e3794 + _e3792);
let _e3892 = local_8.member[1u];
let _e3893 = (_e3891 + _e3892);
let _e3895 = select(_e3811, _e3893, (_e3893 < _e3811));
let _e3900 = global_2.member[bitcast<u32>(select(0i, _e3895, (_e3895 > 0i)))];
let _e3901 = bitcast<f32>(_e3900);
let _e3902 = local_8.member[2u];
let _e3903 = (_e3891 + _e3902);
let _e3905 = select(_e3811, _e3903, (_e3903 < _e3811));
let _e3910 = global_2.member[bitcast<u32>(select(0i, _e3905, (_e3905 > 0i)))];
let _e3912 = local_9[0u];
let _e3916 = local_9[1u];
let _e3921 = local_9[2u];
let _e3928 = global_1.member.member_8.member_6;
let _e3932 = global_1.member.member_8.member_5;
let _e3934 = (((_e3865 + (((_e3890 + (((_e3901 + ((bitcast<f32>(_e3910) - _e3901) * _e3912)) - _e3890) * _e3916)) - _e3865) * _e3921)) - _e3928) * _e3932);
let _e3935 = -(1e9f);
let _e3937 = select(_e3935, _e3934, (_e3934 > _e3935));
let _e3939 = select(1e9f, _e3937, (_e3937 < 1e9f));
let _e3942 = global_1.member.member_1;
let _e3944 = ((_e3942 & 16u) == 0u);
if _e3944 {
phi_10090_ = type_7(1f, 1f, 1f);
} else {
let _e3948 = global_1.member.member_16.member;
let _e3959 = ((((_e3948.member.member * _e1418) + (_e3948.member.member_1 * _e1431)) + (_e3948.member.member_2 * _e1396)) + _e3948.member_1);
let _e3965 = ((((_e3948.member.member * _e1441) + (_e3948.member.member_1 * _e1446)) + (_e3948.member.member_2 * _e1435)) + _e3948.member_1);
let _e3967 = select(_e3965, _e3959, (_e3959 < _e3965));
let _e3969 = select(_e3965, _e3959, (_e3959 > _e3965));
let _e3971 = (_e3969 - _e3967);
let _e3974 = (-(_e3967) / select(1e-30f, _e3971, (_e3971 > 1e-30f)));
let _e3976 = select(0f, _e3974, (_e3974 > 0f));
let _e3982 = select(select(select(1f, _e3976, (_e3976 < 1f)), 1f, (_e3969 <= 0f)), 0f, (_e3967 > 0f));
let _e3987 = global_1.member.member_16.member_1;
let _e3988 = (_e3987 != 0u);
let _e3998 = global_1.member.member_17.member;
let _e4009 = ((((_e3998.member.member * _e1418) + (_e3998.member.member_1 * _e1431)) + (_e3998.member.member_2 * _e1396)) + _e3998.member_1);
let _e4015 = ((((_e3998.member.member * _e1441) + (_e3998.member.member_1 * _e1446)) + (_e3998.member.member_2 * _e1435)) + _e3998.member_1);
let _e4017 = select(_e4015, _e4009, (_e4009 < _e4015));
let _e4019 = select(_e4015, _e4009, (_e4009 > _e4015));
let _e4021 = (_e4019 - _e4017);
let _e4024 = (-(_e4017) / select(1e-30f, _e4021, (_e4021 > 1e-30f)));
let _e4026 = select(0f, _e4024, (_e4024 > 0f));
let _e4032 = select(select(select(1f, _e4026, (_e4026 < 1f)), 1f, (_e4019 <= 0f)), 0f, (_e4017 > 0f));
let _e4037 = global_1.member.member_17.member_1;
let _e4038 = (_e4037 != 0u);
let _e4048 = global_1.member.member_18.member;
let _e4059 = ((((_e4048.member.member * _e1418) + (_e4048.member.member_1 * _e1431)) + (_e4048.member.member_2 * _e1396)) + _e4048.member_1);
let _e4065 = ((((_e4048.member.member * _e1441) + (_e4048.member.member_1 * _e1446)) + (_e4048.member.member_2 * _e1435)) + _e4048.member_1);
let _e4067 = select(_e4065, _e4059, (_e4059 < _e4065));
let _e4069 = select(_e4065, _e4059, (_e4059 > _e4065));
let _e4071 = (_e4069 - _e4067);
let _e4074 = (-(_e4067) / select(1e-30f, _e4071, (_e4071 > 1e-30f)));
let _e4076 = select(0f, _e4074, (_e4074 > 0f));
let _e4082 = select(select(select(1f, _e4076, (_e4076 < 1f)), 1f, (_e4069 <= 0f)), 0f, (_e4067 > 0f));
let _e4087 = global_1.member.member_18.member_1;
let _e4088 = (_e4087 != 0u);
let _e4098 = global_1.member.member_19.member;
let _e4109 = ((((_e4098.member.member * _e1418) + (_e4098.member.member_1 * _e1431)) + (_e4098.member.member_2 * _e1396)) + _e4098.member_1);
let _e4115 = ((((_e4098.member.member * _e1441) + (_e4098.member.member_1 * _e1446)) + (_e4098.member.member_2 * _e1435)) + _e4098.member_1);
let _e4117 = select(_e4115, _e4109, (_e4109 < _e4115));
let _e4119 = select(_e4115, _e4109, (_e4109 > _e4115));
let _e4121 = (_e4119 - _e4117);
let _e4124 = (-(_e4117) / select(1e-30f, _e4121, (_e4121 > 1e-30f)));
let _e4126 = select(0f, _e4124, (_e4124 > 0f));
let _e4132 = select(select(select(1f, _e4126, (_e4126 < 1f)), 1f, (_e4119 <= 0f)), 0f, (_e4117 > 0f));
let _e4137 = global_1.member.member_19.member_1;
let _e4138 = (_e4137 != 0u);
phi_10090_ = type_7(((((1f * _e3982) * _e4032) * _e4082) * _e4132), ((((1f * select(1f, _e3982, _e3988)) * select(1f, _e4032, _e4038)) * select(1f, _e4082, _e4088)) * select(1f, _e4132, _e4138)), ((((1f * select(1f, 0f, (_e3988 && (_e3965 > 0f)))) * select(1f, 0f, (_e4038 && (_e4015 > 0f)))) * select(1f, 0f, (_e4088 && (_e4065 > 0f)))) * select(1f, 0f, (_e4138 && (_e4115 > 0f)))));
}
let _e4147 = phi_10090_;
let _e4148 = (_e1497 - _e1461);
let _e4152 = (bitcast<f32>((bitcast<u32>(_e4148) & 2147483647u)) < 1e-12f);
let _e4154 = (1f / select(_e4148, 1f, _e4152));
let _e4156 = ((-0.5f - _e1461) * _e4154);
let _e4158 = ((_e3668 - _e1461) * _e4154);
let _e4164 = select(_e4158, _e4156, (_e4156 < _e4158));
let _e4166 = select(0f, _e4164, (_e4164 > 0f));
let _e4169 = select(select(1f, _e4166, (_e4166 < 1f)), select(2f, 0f, ((_e1461 >= -0.5f) && (_e1461 <= _e3668))), _e4152);
let _e4171 = select(_e4158, _e4156, (_e4156 > _e4158));
let _e4173 = select(0f, _e4171, (_e4171 > 0f));
let _e4176 = select(select(1f, _e4173, (_e4173 < 1f)), 1f, _e4152);
let _e4177 = (_e1503 - _e1476);
let _e4181 = (bitcast<f32>((bitcast<u32>(_e4177) & 2147483647u)) < 1e-12f);
let _e4183 = (1f / select(_e4177, 1f, _e4181));
let _e4185 = ((-0.5f - _e1476) * _e4183);
let _e4187 = ((_e3678 - _e1476) * _e4183);
let _e4193 = select(_e4187, _e4185, (_e4185 < _e4187));
let _e4195 = select(0f, _e4193, (_e4193 > 0f));
let _e4198 = select(select(1f, _e4195, (_e4195 < 1f)), select(2f, 0f, ((_e1476 >= -0.5f) && (_e1476 <= _e3678))), _e4181);
let _e4200 = select(_e4187, _e4185, (_e4185 > _e4187));
let _e4202 = select(0f, _e4200, (_e4200 > 0f));
let _e4205 = select(select(1f, _e4202, (_e4202 < 1f)), 1f, _e4181);
let _e4206 = (_e1509 - _e1491);
let _e4210 = (bitcast<f32>((bitcast<u32>(_e4206) & 2147483647u)) < 1e-12f);
let _e4212 = (1f / select(_e4206, 1f, _e4210));
let _e4214 = ((-0.5f - _e1491) * _e4212);
let _e4216 = ((_e3688 - _e1491) * _e4212);
let _e4222 = select(_e4216, _e4214, (_e4214 < _e4216));
let _e4224 = select(0f, _e4222, (_e4222 > 0f));
let _e4227 = select(select(1f, _e4224, (_e4224 < 1f)), select(2f, 0f, ((_e1491 >= -0.5f) && (_e1491 <= _e3688))), _e4210);
let _e4229 = select(_e4216, _e4214, (_e4214 > _e4216));
let _e4231 = select(0f, _e4229, (_e4229 > 0f));
let _e4234 = select(select(1f, _e4231, (_e4231 < 1f)), 1f, _e4210);
let _e4236 = select(_e4205, _e4176, (_e4176 < _e4205));
let _e4240 = select(_e4198, _e4169, (_e4169 > _e4198));
let _e4243 = (select(_e4234, _e4236, (_e4236 < _e4234)) - select(_e4227, _e4240, (_e4240 > _e4227)));
let _e4246 = (_e1441 - _e1418);
let _e4247 = (_e1446 - _e1431);
let _e4248 = (_e1435 - _e1396);
let _e4253 = (((_e4246 * _e4246) + (_e4247 * _e4247)) + (_e4248 * _e4248));
let _e4261 = global_1.member.member_7.member_3;
let _e4262 = ((sqrt(select(0f, _e4253, (_e4253 > 0f))) * select(0f, _e4243, (_e4243 > 0f))) * _e4261);
if (((_e178.member_2 == 3u) || (_e178.member_2 == 4u)) || _e1556) {
local_7 = _e3939;
let _e4268 = local_7;
let _e4270 = (bitcast<i32>(_e168) - 1i);
let _e4272 = select(_e4270, 263171i, (263171i < _e4270));
let _e4277 = global_3.member[bitcast<u32>(select(0i, _e4272, (_e4272 > 0i)))];
let _e4278 = bitcast<f32>(_e4277);
let _e4280 = select(_e4270, 263172i, (263172i < _e4270));
let _e4285 = global_3.member[bitcast<u32>(select(0i, _e4280, (_e4280 > 0i)))];
let _e4286 = bitcast<f32>(_e4285);
let _e4288 = select(_e4270, 263173i, (263173i < _e4270));
let _e4293 = global_3.member[bitcast<u32>(select(0i, _e4288, (_e4288 > 0i)))];
let _e4294 = bitcast<f32>(_e4293);
let _e4296 = ((_e4268 - _e4278) * _e4286);
let _e4298 = select(0f, _e4296, (_e4296 > 0f));
let _e4301 = local_7;
let _e4303 = select(_e4270, 263174i, (263174i < _e4270));
let _e4308 = global_3.member[bitcast<u32>(select(0i, _e4303, (_e4303 > 0i)))];
let _e4309 = bitcast<f32>(_e4308);
let _e4311 = select(_e4270, 263175i, (263175i < _e4270));
let _e4316 = global_3.member[bitcast<u32>(select(0i, _e4311, (_e4311 > 0i)))];
let _e4317 = bitcast<f32>(_e4316);
let _e4319 = select(_e4270, 263176i, (263176i < _e4270));
let _e4324 = global_3.member[bitcast<u32>(select(0i, _e4319, (_e4319 > 0i)))];
let _e4325 = bitcast<f32>(_e4324);
let _e4327 = ((_e4301 - _e4309) * _e4317);
let _e4329 = select(0f, _e4327, (_e4327 > 0f));
let _e4333 = local_7;
let _e4335 = select(_e4270, 263177i, (263177i < _e4270));
let _e4340 = global_3.member[bitcast<u32>(select(0i, _e4335, (_e4335 > 0i)))];
let _e4341 = bitcast<f32>(_e4340);
let _e4343 = select(_e4270, 263178i, (263178i < _e4270));
let _e4348 = global_3.member[bitcast<u32>(select(0i, _e4343, (_e4343 > 0i)))];
let _e4349 = bitcast<f32>(_e4348);
let _e4351 = select(_e4270, 263179i, (263179i < _e4270));
let _e4356 = global_3.member[bitcast<u32>(select(0i, _e4351, (_e4351 > 0i)))];
let _e4357 = bitcast<f32>(_e4356);
let _e4359 = ((_e4333 - _e4341) * _e4349);
let _e4361 = select(0f, _e4359, (_e4359 > 0f));
let _e4364 = local_7;
let _e4366 = select(_e4270, 263180i, (263180i < _e4270));
let _e4371 = global_3.member[bitcast<u32>(select(0i, _e4366, (_e4366 > 0i)))];
let _e4372 = bitcast<f32>(_e4371);
let _e4374 = select(_e4270, 263181i, (263181i < _e4270));
let _e4379 = global_3.member[bitcast<u32>(select(0i, _e4374, (_e4374 > 0i)))];
let _e4380 = bitcast<f32>(_e4379);
let _e4382 = select(_e4270, 263182i, (263182i < _e4270));
let _e4387 = global_3.member[bitcast<u32>(select(0i, _e4382, (_e4382 > 0i)))];
let _e4388 = bitcast<f32>(_e4387);
let _e4390 = ((_e4364 - _e4372) * _e4380);
let _e4392 = select(0f, _e4390, (_e4390 > 0f));
let _e4397 = local_7;
let _e4399 = select(_e4270, 263183i, (263183i < _e4270));
let _e4404 = global_3.member[bitcast<u32>(select(0i, _e4399, (_e4399 > 0i)))];
let _e4405 = bitcast<f32>(_e4404);
let _e4407 = select(_e4270, 263184i, (263184i < _e4270));
let _e4412 = global_3.member[bitcast<u32>(select(0i, _e4407, (_e4407 > 0i)))];
let _e4413 = bitcast<f32>(_e4412);
let _e4415 = select(_e4270, 263185i, (263185i < _e4270));
let _e4420 = global_3.member[bitcast<u32>(select(0i, _e4415, (_e4415 > 0i)))];
let _e4421 = bitcast<f32>(_e4420);
let _e4423 = ((_e4397 - _e4405) * _e4413);
let _e4425 = select(0f, _e4423, (_e4423 > 0f));
let _e4428 = local_7;
let _e4430 = select(_e4270, 263186i, (263186i < _e4270));
let _e4435 = global_3.member[bitcast<u32>(select(0i, _e4430, (_e4430 > 0i)))];
let _e4436 = bitcast<f32>(_e4435);
let _e4438 = select(_e4270, 263187i, (263187i < _e4270));
let _e4443 = global_3.member[bitcast<u32>(select(0i, _e4438, (_e4438 > 0i)))];
let _e4444 = bitcast<f32>(_e4443);
let _e4446 = select(_e4270, 263188i, (263188i < _e4270));
let _e4451 = global_3.member[bitcast<u32>(select(0i, _e4446, (_e4446 > 0i)))];
let _e4452 = bitcast<f32>(_e4451);
let _e4454 = ((_e4428 - _e4436) * _e4444);
let _e4456 = select(0f, _e4454, (_e4454 > 0f));
let _e4460 = local_7;
let _e4462 = select(_e4270, 263189i, (263189i < _e4270));
let _e4467 = global_3.member[bitcast<u32>(select(0i, _e4462, (_e4462 > 0i)))];
let _e4468 = bitcast<f32>(_e4467);
let _e4470 = select(_e4270, 263190i, (263190i < _e4270));
let _e4475 = global_3.member[bitcast<u32>(select(0i, _e4470, (_e4470 > 0i)))];
let _e4476 = bitcast<f32>(_e4475);
let _e4478 = select(_e4270, 263191i, (263191i < _e4270));
let _e4483 = global_3.member[bitcast<u32>(select(0i, _e4478, (_e4478 > 0i)))];
let _e4484 = bitcast<f32>(_e4483);
let _e4486 = ((_e4460 - _e4468) * _e4476);
let _e4488 = select(0f, _e4486, (_e4486 > 0f));
let _e4491 = local_7;
let _e4493 = select(_e4270, 263192i, (263192i < _e4270));
let _e4498 = global_3.member[bitcast<u32>(select(0i, _e4493, (_e4493 > 0i)))];
let _e4499 = bitcast<f32>(_e4498);
let _e4501 = select(_e4270, 263193i, (263193i < _e4270));
let _e4506 = global_3.member[bitcast<u32>(select(0i, _e4501, (_e4501 > 0i)))];
let _e4507 = bitcast<f32>(_e4506);
let _e4509 = select(_e4270, 263194i, (263194i < _e4270));
let _e4514 = global_3.member[bitcast<u32>(select(0i, _e4509, (_e4509 > 0i)))];
let _e4515 = bitcast<f32>(_e4514);
let _e4517 = ((_e4491 - _e4499) * _e4507);
let _e4519 = select(0f, _e4517, (_e4517 > 0f));
let _e4524 = (((select(_e4294, _e4298, (_e4298 < _e4294)) + select(_e4325, _e4329, (_e4329 < _e4325))) + (select(_e4357, _e4361, (_e4361 < _e4357)) + select(_e4388, _e4392, (_e4392 < _e4388)))) + ((select(_e4421, _e4425, (_e4425 < _e4421)) + select(_e4452, _e4456, (_e4456 < _e4452))) + (select(_e4484, _e4488, (_e4488 < _e4484)) + select(_e4515, _e4519, (_e4519 < _e4515)))));
local_6 = _e3662.member;
let _e4525 = local_6;
let _e4527 = ((_e4525 - _e4278) * _e4286);
let _e4529 = select(0f, _e4527, (_e4527 > 0f));
let _e4532 = local_6;
let _e4534 = ((_e4532 - _e4309) * _e4317);
let _e4536 = select(0f, _e4534, (_e4534 > 0f));
let _e4540 = local_6;
let _e4542 = ((_e4540 - _e4341) * _e4349);
let _e4544 = select(0f, _e4542, (_e4542 > 0f));
let _e4547 = local_6;
let _e4549 = ((_e4547 - _e4372) * _e4380);
let _e4551 = select(0f, _e4549, (_e4549 > 0f));
let _e4556 = local_6;
let _e4558 = ((_e4556 - _e4405) * _e4413);
let _e4560 = select(0f, _e4558, (_e4558 > 0f));
let _e4563 = local_6;
let _e4565 = ((_e4563 - _e4436) * _e4444);
let _e4567 = select(0f, _e4565, (_e4565 > 0f));
let _e4571 = local_6;
let _e4573 = ((_e4571 - _e4468) * _e4476);
let _e4575 = select(0f, _e4573, (_e4573 > 0f));
let _e4578 = local_6;
let _e4580 = ((_e4578 - _e4499) * _e4507);
let _e4582 = select(0f, _e4580, (_e4580 > 0f));
let _e4587 = (((select(_e4294, _e4529, (_e4529 < _e4294)) + select(_e4325, _e4536, (_e4536 < _e4325))) + (select(_e4357, _e4544, (_e4544 < _e4357)) + select(_e4388, _e4551, (_e4551 < _e4388)))) + ((select(_e4421, _e4560, (_e4560 < _e4421)) + select(_e4452, _e4567, (_e4567 < _e4452))) + (select(_e4484, _e4575, (_e4575 < _e4484)) + select(_e4515, _e4582, (_e4582 < _e4515)))));
let _e4588 = (255f - 1f);
let _e4590 = select(0f, _e4524, (_e4524 > 0f));
let _e4592 = select(_e4588, _e4590, (_e4590 < _e4588));
let _e4599 = select(0i, select(select(i32(_e4592), i32(-2147483648), (_e4592 < -2147483600f)), 2147483647i, (_e4592 > 2147483500f)), (_e4592 == _e4592));
let _e4603 = (_e4599 - select(0i, 1i, (_e4592 < f32(_e4599))));
let _e4605 = select(0f, _e4587, (_e4587 > 0f));
let _e4607 = select(_e4588, _e4605, (_e4605 < _e4588));
let _e4614 = select(0i, select(select(i32(_e4607), i32(-2147483648), (_e4607 < -2147483600f)), 2147483647i, (_e4607 > 2147483500f)), (_e4607 == _e4607));
let _e4618 = (_e4614 - select(0i, 1i, (_e4607 < f32(_e4614))));
let _e4620 = select(_e4270, 263195i, (263195i < _e4270));
let _e4626 = global_3.member[bitcast<u32>(select(0i, _e4620, (_e4620 > 0i)))];
let _e4627 = bitcast<f32>(_e4626);
let _e4629 = select(_e4270, 263196i, (263196i < _e4270));
let _e4635 = global_3.member[bitcast<u32>(select(0i, _e4629, (_e4629 > 0i)))];
let _e4636 = bitcast<f32>(_e4635);
let _e4637 = (_e3662.member - _e3939);
let _e4643 = (1f / select(_e4637, 1f, (bitcast<f32>((bitcast<u32>(_e4637) & 2147483647u)) < 1e-20f)));
let _e4649 = ((select(_e4627, _e3662.member, (_e3662.member < _e4627)) - select(_e4627, _e3939, (_e3939 < _e4627))) * _e4643);
let _e4655 = ((select(_e4636, _e3662.member, (_e3662.member > _e4636)) - select(_e4636, _e3939, (_e3939 > _e4636))) * _e4643);
let _e4658 = (((_e4603 * 256i) + _e4618) * 4i);
let _e4662 = (_e4587 - f32(_e4618));
let _e4666 = select(_e4270, _e4658, (_e4658 < _e4270));
let _e4672 = global_3.member[bitcast<u32>(select(0i, _e4666, (_e4666 > 0i)))];
let _e4673 = (_e4658 + 4i);
let _e4675 = select(_e4270, _e4673, (_e4673 < _e4270));
let _e4681 = global_3.member[bitcast<u32>(select(0i, _e4675, (_e4675 > 0i)))];
let _e4682 = (_e4658 + 1024i);
let _e4684 = select(_e4270, _e4682, (_e4682 < _e4270));
let _e4690 = global_3.member[bitcast<u32>(select(0i, _e4684, (_e4684 > 0i)))];
let _e4691 = (_e4658 + 1028i);
let _e4693 = select(_e4270, _e4691, (_e4691 < _e4270));
let _e4699 = global_3.member[bitcast<u32>(select(0i, _e4693, (_e4693 > 0i)))];
let _e4701 = select(_e4270, 0i, (0i < _e4270));
let _e4707 = global_3.member[bitcast<u32>(select(0i, _e4701, (_e4701 > 0i)))];
let _e4709 = select(_e4270, 262140i, (262140i < _e4270));
let _e4715 = global_3.member[bitcast<u32>(select(0i, _e4709, (_e4709 > 0i)))];
let _e4720 = (bitcast<f32>(((_e4672 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4728 = (_e4720 + (((bitcast<f32>(((_e4681 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4720) * _e4662));
let _e4733 = (bitcast<f32>(((_e4690 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e4759 = (((_e4728 + (((_e4733 + (((bitcast<f32>(((_e4699 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e4733) * _e4662)) - _e4728) * (_e4524 - f32(_e4603)))) * (1f - (_e4649 + _e4655))) + (((bitcast<f32>(((_e4707 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4649) + ((bitcast<f32>(((_e4715 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e4655)));
let _e4763 = -((_e4759 * (_e4262 * _e4147.member)));
let _e4765 = select(-87f, _e4763, (_e4763 > -87f));
let _e4767 = select(88f, _e4765, (_e4765 < 88f));
let _e4769 = ((_e4767 * 1.442695f) + 0.5f);
let _e4771 = select(-127f, _e4769, (_e4769 > -127f));
let _e4773 = select(128f, _e4771, (_e4771 < 128f));
let _e4780 = select(0i, select(select(i32(_e4773), i32(-2147483648), (_e4773 < -2147483600f)), 2147483647i, (_e4773 > 2147483500f)), (_e4773 == _e4773));
let _e4784 = (_e4780 - select(0i, 1i, (_e4773 < f32(_e4780))));
let _e4785 = f32(_e4784);
let _e4789 = ((_e4767 - (_e4785 * 0.6933594f)) - (_e4785 * -2.1219444e-4f));
let _e4809 = ((1f + (_e4789 * (1f + (_e4789 * (0.5f + (_e4789 * (0.16666667f + (_e4789 * (0.041666668f + (_e4789 * (0.008333334f + (_e4789 * (0.001388889f + (_e4789 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4784 + 127i)) << bitcast<u32>(23i))));
let _e4810 = (1f - _e4809);
phi_13818_ = type_35(_e4809, _e4810, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e4810 / select(1e-12f, _e4759, (_e4759 > 1e-12f))))));
} else {
local_5 = _e3939;
let _e4818 = local_5;
let _e4820 = (bitcast<i32>(_e168) - 1i);
let _e4822 = select(_e4820, 263171i, (263171i < _e4820));
let _e4827 = global_3.member[bitcast<u32>(select(0i, _e4822, (_e4822 > 0i)))];
let _e4828 = bitcast<f32>(_e4827);
let _e4830 = select(_e4820, 263172i, (263172i < _e4820));
let _e4835 = global_3.member[bitcast<u32>(select(0i, _e4830, (_e4830 > 0i)))];
let _e4836 = bitcast<f32>(_e4835);
let _e4838 = select(_e4820, 263173i, (263173i < _e4820));
let _e4843 = global_3.member[bitcast<u32>(select(0i, _e4838, (_e4838 > 0i)))];
let _e4844 = bitcast<f32>(_e4843);
let _e4846 = ((_e4818 - _e4828) * _e4836);
let _e4848 = select(0f, _e4846, (_e4846 > 0f));
let _e4851 = local_5;
let _e4853 = select(_e4820, 263174i, (263174i < _e4820));
let _e4858 = global_3.member[bitcast<u32>(select(0i, _e4853, (_e4853 > 0i)))];
let _e4859 = bitcast<f32>(_e4858);
let _e4861 = select(_e4820, 263175i, (263175i < _e4820));
let _e4866 = global_3.member[bitcast<u32>(select(0i, _e4861, (_e4861 > 0i)))];
let _e4867 = bitcast<f32>(_e4866);
let _e4869 = select(_e4820, 263176i, (263176i < _e4820));
let _e4874 = global_3.member[bitcast<u32>(select(0i, _e4869, (_e4869 > 0i)))];
let _e4875 = bitcast<f32>(_e4874);
let _e4877 = ((_e4851 - _e4859) * _e4867);
let _e4879 = select(0f, _e4877, (_e4877 > 0f));
let _e4883 = local_5;
let _e4885 = select(_e4820, 263177i, (263177i < _e4820));
let _e4890 = global_3.member[bitcast<u32>(select(0i, _e4885, (_e4885 > 0i)))];
let _e4891 = bitcast<f32>(_e4890);
let _e4893 = select(_e4820, 263178i, (263178i < _e4820));
let _e4898 = global_3.member[bitcast<u32>(select(0i, _e4893, (_e4893 > 0i)))];
let _e4899 = bitcast<f32>(_e4898);
let _e4901 = select(_e4820, 263179i, (263179i < _e4820));
let _e4906 = global_3.member[bitcast<u32>(select(0i, _e4901, (_e4901 > 0i)))];
let _e4907 = bitcast<f32>(_e4906);
let _e4909 = ((_e4883 - _e4891) * _e4899);
let _e4911 = select(0f, _e4909, (_e4909 > 0f));
let _e4914 = local_5;
let _e4916 = select(_e4820, 263180i, (263180i < _e4820));
let _e4921 = global_3.member[bitcast<u32>(select(0i, _e4916, (_e4916 > 0i)))];
let _e4922 = bitcast<f32>(_e4921);
let _e4924 = select(_e4820, 263181i, (263181i < _e4820));
let _e4929 = global_3.member[bitcast<u32>(select(0i, _e4924, (_e4924 > 0i)))];
let _e4930 = bitcast<f32>(_e4929);
let _e4932 = select(_e4820, 263182i, (263182i < _e4820));
let _e4937 = global_3.member[bitcast<u32>(select(0i, _e4932, (_e4932 > 0i)))];
let _e4938 = bitcast<f32>(_e4937);
let _e4940 = ((_e4914 - _e4922) * _e4930);
let _e4942 = select(0f, _e4940, (_e4940 > 0f));
let _e4947 = local_5;
let _e4949 = select(_e4820, 263183i, (263183i < _e4820));
let _e4954 = global_3.member[bitcast<u32>(select(0i, _e4949, (_e4949 > 0i)))];
let _e4955 = bitcast<f32>(_e4954);
let _e4957 = select(_e4820, 263184i, (263184i < _e4820));
let _e4962 = global_3.member[bitcast<u32>(select(0i, _e4957, (_e4957 > 0i)))];
let _e4963 = bitcast<f32>(_e4962);
let _e4965 = select(_e4820, 263185i, (263185i < _e4820));
let _e4970 = global_3.member[bitcast<u32>(select(0i, _e4965, (_e4965 > 0i)))];
let _e4971 = bitcast<f32>(_e4970);
let _e4973 = ((_e4947 - _e4955) * _e4963);
let _e4975 = select(0f, _e4973, (_e4973 > 0f));
let _e4978 = local_5;
let _e4980 = select(_e4820, 263186i, (263186i < _e4820));
let _e4985 = global_3.member[bitcast<u32>(select(0i, _e4980, (_e4980 > 0i)))];
let _e4986 = bitcast<f32>(_e4985);
let _e4988 = select(_e4820, 263187i, (263187i < _e4820));
let _e4993 = global_3.member[bitcast<u32>(select(0i, _e4988, (_e4988 > 0i)))];
let _e4994 = bitcast<f32>(_e4993);
let _e4996 = select(_e4820, 263188i, (263188i < _e4820));
let _e5001 = global_3.member[bitcast<u32>(select(0i, _e4996, (_e4996 > 0i)))];
let _e5002 = bitcast<f32>(_e5001);
let _e5004 = ((_e4978 - _e4986) * _e4994);
let _e5006 = select(0f, _e5004, (_e5004 > 0f));
let _e5010 = local_5;
let _e5012 = select(_e4820, 263189i, (263189i < _e4820));
let _e5017 = global_3.member[bitcast<u32>(select(0i, _e5012, (_e5012 > 0i)))];
let _e5018 = bitcast<f32>(_e5017);
let _e5020 = select(_e4820, 263190i, (263190i < _e4820));
let _e5025 = global_3.member[bitcast<u32>(select(0i, _e5020, (_e5020 > 0i)))];
let _e5026 = bitcast<f32>(_e5025);
let _e5028 = select(_e4820, 263191i, (263191i < _e4820));
let _e5033 = global_3.member[bitcast<u32>(select(0i, _e5028, (_e5028 > 0i)))];
let _e5034 = bitcast<f32>(_e5033);
let _e5036 = ((_e5010 - _e5018) * _e5026);
let _e5038 = select(0f, _e5036, (_e5036 > 0f));
let _e5041 = local_5;
let _e5043 = select(_e4820, 263192i, (263192i < _e4820));
let _e5048 = global_3.member[bitcast<u32>(select(0i, _e5043, (_e5043 > 0i)))];
let _e5049 = bitcast<f32>(_e5048);
let _e5051 = select(_e4820, 263193i, (263193i < _e4820));
let _e5056 = global_3.member[bitcast<u32>(select(0i, _e5051, (_e5051 > 0i)))];
let _e5057 = bitcast<f32>(_e5056);
let _e5059 = select(_e4820, 263194i, (263194i < _e4820));
let _e5064 = global_3.member[bitcast<u32>(select(0i, _e5059, (_e5059 > 0i)))];
let _e5065 = bitcast<f32>(_e5064);
let _e5067 = ((_e5041 - _e5049) * _e5057);
let _e5069 = select(0f, _e5067, (_e5067 > 0f));
let _e5074 = (((select(_e4844, _e4848, (_e4848 < _e4844)) + select(_e4875, _e4879, (_e4879 < _e4875))) + (select(_e4907, _e4911, (_e4911 < _e4907)) + select(_e4938, _e4942, (_e4942 < _e4938)))) + ((select(_e4971, _e4975, (_e4975 < _e4971)) + select(_e5002, _e5006, (_e5006 < _e5002))) + (select(_e5034, _e5038, (_e5038 < _e5034)) + select(_e5065, _e5069, (_e5069 < _e5065)))));
local_4 = _e3662.member;
let _e5075 = local_4;
let _e5077 = ((_e5075 - _e4828) * _e4836);
let _e5079 = select(0f, _e5077, (_e5077 > 0f));
let _e5082 = local_4;
let _e5084 = ((_e5082 - _e4859) * _e4867);
let _e5086 = select(0f, _e5084, (_e5084 > 0f));
let _e5090 = local_4;
let _e5092 = ((_e5090 - _e4891) * _e4899);
let _e5094 = select(0f, _e5092, (_e5092 > 0f));
let _e5097 = local_4;
let _e5099 = ((_e5097 - _e4922) * _e4930);
let _e5101 = select(0f, _e5099, (_e5099 > 0f));
let _e5106 = local_4;
let _e5108 = ((_e5106 - _e4955) * _e4963);
let _e5110 = select(0f, _e5108, (_e5108 > 0f));
let _e5113 = local_4;
let _e5115 = ((_e5113 - _e4986) * _e4994);
let _e5117 = select(0f, _e5115, (_e5115 > 0f));
let _e5121 = local_4;
let _e5123 = ((_e5121 - _e5018) * _e5026);
let _e5125 = select(0f, _e5123, (_e5123 > 0f));
let _e5128 = local_4;
let _e5130 = ((_e5128 - _e5049) * _e5057);
let _e5132 = select(0f, _e5130, (_e5130 > 0f));
let _e5137 = (((select(_e4844, _e5079, (_e5079 < _e4844)) + select(_e4875, _e5086, (_e5086 < _e4875))) + (select(_e4907, _e5094, (_e5094 < _e4907)) + select(_e4938, _e5101, (_e5101 < _e4938)))) + ((select(_e4971, _e5110, (_e5110 < _e4971)) + select(_e5002, _e5117, (_e5117 < _e5002))) + (select(_e5034, _e5125, (_e5125 < _e5034)) + select(_e5065, _e5132, (_e5132 < _e5065)))));
let _e5138 = (255f - 1f);
let _e5140 = select(0f, _e5074, (_e5074 > 0f));
let _e5142 = select(_e5138, _e5140, (_e5140 < _e5138));
let _e5149 = select(0i, select(select(i32(_e5142), i32(-2147483648), (_e5142 < -2147483600f)), 2147483647i, (_e5142 > 2147483500f)), (_e5142 == _e5142));
let _e5153 = (_e5149 - select(0i, 1i, (_e5142 < f32(_e5149))));
let _e5155 = select(0f, _e5137, (_e5137 > 0f));
let _e5157 = select(_e5138, _e5155, (_e5155 < _e5138));
let _e5164 = select(0i, select(select(i32(_e5157), i32(-2147483648), (_e5157 < -2147483600f)), 2147483647i, (_e5157 > 2147483500f)), (_e5157 == _e5157));
let _e5168 = (_e5164 - select(0i, 1i, (_e5157 < f32(_e5164))));
let _e5170 = select(_e4820, 263195i, (263195i < _e4820));
let _e5176 = global_3.member[bitcast<u32>(select(0i, _e5170, (_e5170 > 0i)))];
let _e5177 = bitcast<f32>(_e5176);
let _e5179 = select(_e4820, 263196i, (263196i < _e4820));
let _e5185 = global_3.member[bitcast<u32>(select(0i, _e5179, (_e5179 > 0i)))];
let _e5186 = bitcast<f32>(_e5185);
let _e5187 = (_e3662.member - _e3939);
let _e5193 = (1f / select(_e5187, 1f, (bitcast<f32>((bitcast<u32>(_e5187) & 2147483647u)) < 1e-20f)));
let _e5199 = ((select(_e5177, _e3662.member, (_e3662.member < _e5177)) - select(_e5177, _e3939, (_e3939 < _e5177))) * _e5193);
let _e5205 = ((select(_e5186, _e3662.member, (_e3662.member > _e5186)) - select(_e5186, _e3939, (_e3939 > _e5186))) * _e5193);
let _e5208 = (((_e5153 * 256i) + _e5168) * 4i);
let _e5210 = (_e5074 - f32(_e5153));
let _e5212 = (_e5137 - f32(_e5168));
let _e5214 = (1f - (_e5199 + _e5205));
let _e5216 = select(_e4820, _e5208, (_e5208 < _e4820));
let _e5222 = global_3.member[bitcast<u32>(select(0i, _e5216, (_e5216 > 0i)))];
let _e5223 = (_e5208 + 4i);
let _e5225 = select(_e4820, _e5223, (_e5223 < _e4820));
let _e5231 = global_3.member[bitcast<u32>(select(0i, _e5225, (_e5225 > 0i)))];
let _e5232 = (_e5208 + 1024i);
let _e5234 = select(_e4820, _e5232, (_e5232 < _e4820));
let _e5240 = global_3.member[bitcast<u32>(select(0i, _e5234, (_e5234 > 0i)))];
let _e5241 = (_e5208 + 1028i);
let _e5243 = select(_e4820, _e5241, (_e5241 < _e4820));
let _e5249 = global_3.member[bitcast<u32>(select(0i, _e5243, (_e5243 > 0i)))];
let _e5251 = select(_e4820, 0i, (0i < _e4820));
let _e5257 = global_3.member[bitcast<u32>(select(0i, _e5251, (_e5251 > 0i)))];
let _e5259 = select(_e4820, 262140i, (262140i < _e4820));
let _e5265 = global_3.member[bitcast<u32>(select(0i, _e5259, (_e5259 > 0i)))];
let _e5270 = (bitcast<f32>(((_e5222 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5278 = (_e5270 + (((bitcast<f32>(((_e5231 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5270) * _e5212));
let _e5283 = (bitcast<f32>(((_e5240 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5309 = (((_e5278 + (((_e5283 + (((bitcast<f32>(((_e5249 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5283) * _e5212)) - _e5278) * _e5210)) * _e5214) + (((bitcast<f32>(((_e5257 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5199) + ((bitcast<f32>(((_e5265 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5205)));
let _e5326 = (bitcast<f32>((((_e5222 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5334 = (_e5326 + (((bitcast<f32>((((_e5231 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5326) * _e5212));
let _e5339 = (bitcast<f32>((((_e5240 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5366 = (_e5208 + 1i);
let _e5368 = select(_e4820, _e5366, (_e5366 < _e4820));
let _e5374 = global_3.member[bitcast<u32>(select(0i, _e5368, (_e5368 > 0i)))];
let _e5375 = (_e5208 + 5i);
let _e5377 = select(_e4820, _e5375, (_e5375 < _e4820));
let _e5383 = global_3.member[bitcast<u32>(select(0i, _e5377, (_e5377 > 0i)))];
let _e5384 = (_e5208 + 1025i);
let _e5386 = select(_e4820, _e5384, (_e5384 < _e4820));
let _e5392 = global_3.member[bitcast<u32>(select(0i, _e5386, (_e5386 > 0i)))];
let _e5393 = (_e5208 + 1029i);
let _e5395 = select(_e4820, _e5393, (_e5393 < _e4820));
let _e5401 = global_3.member[bitcast<u32>(select(0i, _e5395, (_e5395 > 0i)))];
let _e5403 = select(_e4820, 1i, (1i < _e4820));
let _e5409 = global_3.member[bitcast<u32>(select(0i, _e5403, (_e5403 > 0i)))];
let _e5411 = select(_e4820, 262141i, (262141i < _e4820));
let _e5417 = global_3.member[bitcast<u32>(select(0i, _e5411, (_e5411 > 0i)))];
let _e5422 = (bitcast<f32>(((_e5374 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5430 = (_e5422 + (((bitcast<f32>(((_e5383 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5422) * _e5212));
let _e5435 = (bitcast<f32>(((_e5392 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5478 = (bitcast<f32>((((_e5374 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5486 = (_e5478 + (((bitcast<f32>((((_e5383 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5478) * _e5212));
let _e5491 = (bitcast<f32>((((_e5392 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e5521 = (_e4262 * _e4147.member_1);
let _e5523 = -(((((_e5334 + (((_e5339 + (((bitcast<f32>((((_e5249 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5339) * _e5212)) - _e5334) * _e5210)) * _e5214) + (((bitcast<f32>((((_e5257 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5199) + ((bitcast<f32>((((_e5265 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5205))) * _e5521));
let _e5525 = select(-87f, _e5523, (_e5523 > -87f));
let _e5527 = select(88f, _e5525, (_e5525 < 88f));
let _e5529 = ((_e5527 * 1.442695f) + 0.5f);
let _e5531 = select(-127f, _e5529, (_e5529 > -127f));
let _e5533 = select(128f, _e5531, (_e5531 < 128f));
let _e5540 = select(0i, select(select(i32(_e5533), i32(-2147483648), (_e5533 < -2147483600f)), 2147483647i, (_e5533 > 2147483500f)), (_e5533 == _e5533));
let _e5544 = (_e5540 - select(0i, 1i, (_e5533 < f32(_e5540))));
let _e5545 = f32(_e5544);
let _e5549 = ((_e5527 - (_e5545 * 0.6933594f)) - (_e5545 * -2.1219444e-4f));
let _e5571 = -(((((_e5430 + (((_e5435 + (((bitcast<f32>(((_e5401 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5435) * _e5212)) - _e5430) * _e5210)) * _e5214) + (((bitcast<f32>(((_e5409 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5199) + ((bitcast<f32>(((_e5417 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5205))) * _e5521));
let _e5573 = select(-87f, _e5571, (_e5571 > -87f));
let _e5575 = select(88f, _e5573, (_e5573 < 88f));
let _e5577 = ((_e5575 * 1.442695f) + 0.5f);
let _e5579 = select(-127f, _e5577, (_e5577 > -127f));
let _e5581 = select(128f, _e5579, (_e5579 < 128f));
let _e5588 = select(0i, select(select(i32(_e5581), i32(-2147483648), (_e5581 < -2147483600f)), 2147483647i, (_e5581 > 2147483500f)), (_e5581 == _e5581));
let _e5592 = (_e5588 - select(0i, 1i, (_e5581 < f32(_e5588))));
let _e5593 = f32(_e5592);
let _e5597 = ((_e5575 - (_e5593 * 0.6933594f)) - (_e5593 * -2.1219444e-4f));
let _e5619 = -(((((_e5486 + (((_e5491 + (((bitcast<f32>((((_e5401 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e5491) * _e5212)) - _e5486) * _e5210)) * _e5214) + (((bitcast<f32>((((_e5409 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5199) + ((bitcast<f32>((((_e5417 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) * _e5205))) * _e5521));
let _e5621 = select(-87f, _e5619, (_e5619 > -87f));
let _e5623 = select(88f, _e5621, (_e5621 < 88f));
let _e5625 = ((_e5623 * 1.442695f) + 0.5f);
let _e5627 = select(-127f, _e5625, (_e5625 > -127f));
let _e5629 = select(128f, _e5627, (_e5627 < 128f));
let _e5636 = select(0i, select(select(i32(_e5629), i32(-2147483648), (_e5629 < -2147483600f)), 2147483647i, (_e5629 > 2147483500f)), (_e5629 == _e5629));
let _e5640 = (_e5636 - select(0i, 1i, (_e5629 < f32(_e5636))));
let _e5641 = f32(_e5640);
let _e5645 = ((_e5623 - (_e5641 * 0.6933594f)) - (_e5641 * -2.1219444e-4f));
let _e5668 = -((_e5309 * (_e4262 * _e4147.member)));
let _e5670 = select(-87f, _e5668, (_e5668 > -87f));
let _e5672 = select(88f, _e5670, (_e5670 < 88f));
let _e5674 = ((_e5672 * 1.442695f) + 0.5f);
let _e5676 = select(-127f, _e5674, (_e5674 > -127f));
let _e5678 = select(128f, _e5676, (_e5676 < 128f));
let _e5685 = select(0i, select(select(i32(_e5678), i32(-2147483648), (_e5678 < -2147483600f)), 2147483647i, (_e5678 > 2147483500f)), (_e5678 == _e5678));
let _e5689 = (_e5685 - select(0i, 1i, (_e5678 < f32(_e5685))));
let _e5690 = f32(_e5689);
let _e5694 = ((_e5672 - (_e5690 * 0.6933594f)) - (_e5690 * -2.1219444e-4f));
let _e5714 = ((1f + (_e5694 * (1f + (_e5694 * (0.5f + (_e5694 * (0.16666667f + (_e5694 * (0.041666668f + (_e5694 * (0.008333334f + (_e5694 * (0.001388889f + (_e5694 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5689 + 127i)) << bitcast<u32>(23i))));
let _e5715 = (1f - _e5714);
phi_13818_ = type_35(_e5714, _e5715, vec3<f32>(((1f + (_e5549 * (1f + (_e5549 * (0.5f + (_e5549 * (0.16666667f + (_e5549 * (0.041666668f + (_e5549 * (0.008333334f + (_e5549 * (0.001388889f + (_e5549 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5544 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e5597 * (1f + (_e5597 * (0.5f + (_e5597 * (0.16666667f + (_e5597 * (0.041666668f + (_e5597 * (0.008333334f + (_e5597 * (0.001388889f + (_e5597 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5592 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e5645 * (1f + (_e5645 * (0.5f + (_e5645 * (0.16666667f + (_e5645 * (0.041666668f + (_e5645 * (0.008333334f + (_e5645 * (0.001388889f + (_e5645 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5640 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e5715 / select(1e-12f, _e5309, (_e5309 > 1e-12f))))));
}
let _e5723 = phi_13818_;
if _e1563 {
let _e5729 = ((((_e1513.member.member * _e1418) + (_e1513.member.member_1 * _e1431)) + (_e1513.member.member_2 * _e1396)) + _e1513.member_1);
let _e5735 = ((((_e1528.member.member * _e1418) + (_e1528.member.member_1 * _e1431)) + (_e1528.member.member_2 * _e1396)) + _e1528.member_1);
let _e5741 = ((((_e1543.member.member * _e1418) + (_e1543.member.member_1 * _e1431)) + (_e1543.member.member_2 * _e1396)) + _e1543.member_1);
let _e5746 = global_1.member.member_9.member.member;
let _e5754 = global_1.member.member_9.member_1.member;
let _e5762 = global_1.member.member_9.member_2.member;
let _e5770 = global_1.member.member_9.member_3.member;
let _e5771 = (_e5770 - 0.5f);
let _e5772 = (-0.5f - _e5729);
let _e5773 = (-0.5f - _e1524);
let _e5774 = -(_e5772);
let _e5777 = (_e5772 - _e5773);
let _e5778 = (_e5773 - _e5772);
let _e5780 = select(_e5778, _e5777, (_e5777 > _e5778));
let _e5783 = (select(_e5774, _e5772, (_e5772 > _e5774)) / select(1e-30f, _e5780, (_e5780 > 1e-30f)));
let _e5785 = (_e5773 < 0f);
let _e5787 = select(0f, select(2f, _e5783, _e5785), (_e5772 > 0f));
let _e5788 = (_e5773 > 0f);
let _e5791 = select(2f, select(0f, _e5783, (_e5772 < 0f)), _e5788);
let _e5792 = (_e5772 > -1e30f);
let _e5796 = ((_e5787 > -1f) || ((_e5787 == -1f) && _e5792));
let _e5797 = (_e5791 < 2f);
let _e5798 = select(-1f, _e5787, _e5796);
let _e5802 = select(2f, _e5791, _e5797);
let _e5806 = select(-1e30f, _e5772, _e5792);
let _e5807 = (_e5773 > -1e30f);
let _e5808 = select(-1e30f, _e5773, _e5807);
let _e5812 = (_e5729 - _e5771);
let _e5813 = (_e1524 - _e5771);
let _e5814 = -(_e5812);
let _e5817 = (_e5812 - _e5813);
let _e5818 = (_e5813 - _e5812);
let _e5820 = select(_e5818, _e5817, (_e5817 > _e5818));
let _e5823 = (select(_e5814, _e5812, (_e5812 > _e5814)) / select(1e-30f, _e5820, (_e5820 > 1e-30f)));
let _e5825 = (_e5813 < 0f);
let _e5827 = select(0f, select(2f, _e5823, _e5825), (_e5812 > 0f));
let _e5828 = (_e5813 > 0f);
let _e5831 = select(2f, select(0f, _e5823, (_e5812 < 0f)), _e5828);
let _e5832 = (_e5812 > _e5806);
let _e5836 = ((_e5827 > _e5798) || ((_e5827 == _e5798) && _e5832));
let _e5837 = (_e5831 < _e5802);
let _e5838 = select(_e5798, _e5827, _e5836);
let _e5842 = select(_e5802, _e5831, _e5837);
let _e5846 = select(_e5806, _e5812, _e5832);
let _e5847 = (_e5813 > _e5808);
let _e5848 = select(_e5808, _e5813, _e5847);
let _e5856 = global_1.member.member_9.member_3.member_1;
let _e5857 = (_e5856 - 0.5f);
let _e5858 = (-0.5f - _e5735);
let _e5859 = (-0.5f - _e1539);
let _e5860 = -(_e5858);
let _e5863 = (_e5858 - _e5859);
let _e5864 = (_e5859 - _e5858);
let _e5866 = select(_e5864, _e5863, (_e5863 > _e5864));
let _e5869 = (select(_e5860, _e5858, (_e5858 > _e5860)) / select(1e-30f, _e5866, (_e5866 > 1e-30f)));
let _e5871 = (_e5859 < 0f);
let _e5873 = select(0f, select(2f, _e5869, _e5871), (_e5858 > 0f));
let _e5874 = (_e5859 > 0f);
let _e5877 = select(2f, select(0f, _e5869, (_e5858 < 0f)), _e5874);
let _e5878 = (_e5858 > _e5846);
let _e5882 = ((_e5873 > _e5838) || ((_e5873 == _e5838) && _e5878));
let _e5883 = (_e5877 < _e5842);
let _e5884 = select(_e5838, _e5873, _e5882);
let _e5888 = select(_e5842, _e5877, _e5883);
let _e5892 = select(_e5846, _e5858, _e5878);
let _e5893 = (_e5859 > _e5848);
let _e5894 = select(_e5848, _e5859, _e5893);
let _e5898 = (_e5735 - _e5857);
let _e5899 = (_e1539 - _e5857);
let _e5900 = -(_e5898);
let _e5903 = (_e5898 - _e5899);
let _e5904 = (_e5899 - _e5898);
let _e5906 = select(_e5904, _e5903, (_e5903 > _e5904));
let _e5909 = (select(_e5900, _e5898, (_e5898 > _e5900)) / select(1e-30f, _e5906, (_e5906 > 1e-30f)));
let _e5911 = (_e5899 < 0f);
let _e5913 = select(0f, select(2f, _e5909, _e5911), (_e5898 > 0f));
let _e5914 = (_e5899 > 0f);
let _e5917 = select(2f, select(0f, _e5909, (_e5898 < 0f)), _e5914);
let _e5918 = (_e5898 > _e5892);
let _e5922 = ((_e5913 > _e5884) || ((_e5913 == _e5884) && _e5918));
let _e5923 = (_e5917 < _e5888);
let _e5924 = select(_e5884, _e5913, _e5922);
let _e5928 = select(_e5888, _e5917, _e5923);
let _e5932 = select(_e5892, _e5898, _e5918);
let _e5933 = (_e5899 > _e5894);
let _e5934 = select(_e5894, _e5899, _e5933);
let _e5942 = global_1.member.member_9.member_3.member_2;
let _e5943 = (_e5942 - 0.5f);
let _e5944 = (-0.5f - _e5741);
let _e5945 = (-0.5f - _e1554);
let _e5946 = -(_e5944);
let _e5949 = (_e5944 - _e5945);
let _e5950 = (_e5945 - _e5944);
let _e5952 = select(_e5950, _e5949, (_e5949 > _e5950));
let _e5955 = (select(_e5946, _e5944, (_e5944 > _e5946)) / select(1e-30f, _e5952, (_e5952 > 1e-30f)));
let _e5957 = (_e5945 < 0f);
let _e5959 = select(0f, select(2f, _e5955, _e5957), (_e5944 > 0f));
let _e5960 = (_e5945 > 0f);
let _e5963 = select(2f, select(0f, _e5955, (_e5944 < 0f)), _e5960);
let _e5964 = (_e5944 > _e5932);
let _e5968 = ((_e5959 > _e5924) || ((_e5959 == _e5924) && _e5964));
let _e5969 = (_e5963 < _e5928);
let _e5970 = select(_e5924, _e5959, _e5968);
let _e5974 = select(_e5928, _e5963, _e5969);
let _e5978 = select(_e5932, _e5944, _e5964);
let _e5979 = (_e5945 > _e5934);
let _e5980 = select(_e5934, _e5945, _e5979);
let _e5984 = (_e5741 - _e5943);
let _e5985 = (_e1554 - _e5943);
let _e5986 = -(_e5984);
let _e5989 = (_e5984 - _e5985);
let _e5990 = (_e5985 - _e5984);
let _e5992 = select(_e5990, _e5989, (_e5989 > _e5990));
let _e5995 = (select(_e5986, _e5984, (_e5984 > _e5986)) / select(1e-30f, _e5992, (_e5992 > 1e-30f)));
let _e5997 = (_e5985 < 0f);
let _e5999 = select(0f, select(2f, _e5995, _e5997), (_e5984 > 0f));
let _e6000 = (_e5985 > 0f);
let _e6003 = select(2f, select(0f, _e5995, (_e5984 < 0f)), _e6000);
let _e6004 = (_e5984 > _e5978);
let _e6008 = ((_e5999 > _e5970) || ((_e5999 == _e5970) && _e6004));
let _e6009 = (_e6003 < _e5974);
let _e6010 = select(_e5970, _e5999, _e6008);
let _e6011 = select(select(select(select(select(select(0f, _e5746.member, _e5796), _e5746.member, _e5836), _e5754.member, _e5882), _e5754.member, _e5922), _e5762.member, _e5968), _e5762.member, _e6008);
let _e6012 = select(select(select(select(select(select(0f, _e5746.member_1, _e5796), _e5746.member_1, _e5836), _e5754.member_1, _e5882), _e5754.member_1, _e5922), _e5762.member_1, _e5968), _e5762.member_1, _e6008);
let _e6013 = select(select(select(select(select(select(1f, _e5746.member_2, _e5796), _e5746.member_2, _e5836), _e5754.member_2, _e5882), _e5754.member_2, _e5922), _e5762.member_2, _e5968), _e5762.member_2, _e6008);
let _e6015 = select(_e5974, _e6003, _e6009);
let _e6016 = select(select(select(select(select(select(0f, _e5746.member, _e5797), _e5746.member, _e5837), _e5754.member, _e5883), _e5754.member, _e5923), _e5762.member, _e5969), _e5762.member, _e6009);
let _e6017 = select(select(select(select(select(select(0f, _e5746.member_1, _e5797), _e5746.member_1, _e5837), _e5754.member_1, _e5883), _e5754.member_1, _e5923), _e5762.member_1, _e5969), _e5762.member_1, _e6009);
let _e6018 = select(select(select(select(select(select(1f, _e5746.member_2, _e5797), _e5746.member_2, _e5837), _e5754.member_2, _e5883), _e5754.member_2, _e5923), _e5762.member_2, _e5969), _e5762.member_2, _e6009);
let _e6020 = select(_e5978, _e5984, _e6004);
let _e6021 = (_e5985 > _e5980);
let _e6022 = select(_e5980, _e5985, _e6021);
let _e6023 = select(select(select(select(select(select(0f, _e5746.member, _e5792), _e5746.member, _e5832), _e5754.member, _e5878), _e5754.member, _e5918), _e5762.member, _e5964), _e5762.member, _e6004);
let _e6024 = select(select(select(select(select(select(0f, _e5746.member_1, _e5792), _e5746.member_1, _e5832), _e5754.member_1, _e5878), _e5754.member_1, _e5918), _e5762.member_1, _e5964), _e5762.member_1, _e6004);
let _e6025 = select(select(select(select(select(select(1f, _e5746.member_2, _e5792), _e5746.member_2, _e5832), _e5754.member_2, _e5878), _e5754.member_2, _e5918), _e5762.member_2, _e5964), _e5762.member_2, _e6004);
if _e3944 {
phi_15137_ = type_34(_e6010, vec3<f32>(_e6011, _e6012, _e6013), _e6015, vec3<f32>(_e6016, _e6017, _e6018), _e6020, _e6022, vec3<f32>(_e6023, _e6024, _e6025));
} else {
let _e6032 = (((_e5746.member * _e5746.member) + (_e5746.member_1 * _e5746.member_1)) + (_e5746.member_2 * _e5746.member_2));
let _e6035 = sqrt(select(0f, _e6032, (_e6032 > 0f)));
let _e6039 = global_1.member.member_16.member_1;
let _e6040 = (_e6039 != 0u);
let _e6044 = global_1.member.member_16.member;
let _e6064 = select(-1e6f, (((((_e6044.member.member * _e1418) + (_e6044.member.member_1 * _e1431)) + (_e6044.member.member_2 * _e1396)) + _e6044.member_1) * _e6035), _e6040);
let _e6065 = select(-1e6f, (((((_e6044.member.member * _e1441) + (_e6044.member.member_1 * _e1446)) + (_e6044.member.member_2 * _e1435)) + _e6044.member_1) * _e6035), _e6040);
let _e6070 = global_1.member.member_16.member.member;
let _e6074 = -(_e6064);
let _e6077 = (_e6064 - _e6065);
let _e6078 = (_e6065 - _e6064);
let _e6080 = select(_e6078, _e6077, (_e6077 > _e6078));
let _e6083 = (select(_e6074, _e6064, (_e6064 > _e6074)) / select(1e-30f, _e6080, (_e6080 > 1e-30f)));
let _e6087 = select(0f, select(2f, _e6083, (_e6065 < 0f)), (_e6064 > 0f));
let _e6091 = select(2f, select(0f, _e6083, (_e6064 < 0f)), (_e6065 > 0f));
let _e6092 = (_e6064 > _e6020);
let _e6096 = ((_e6087 > _e6010) || ((_e6087 == _e6010) && _e6092));
let _e6097 = (_e6091 < _e6015);
let _e6098 = select(_e6010, _e6087, _e6096);
let _e6102 = select(_e6015, _e6091, _e6097);
let _e6106 = select(_e6020, _e6064, _e6092);
let _e6108 = select(_e6022, _e6065, (_e6065 > _e6022));
let _e6115 = global_1.member.member_17.member_1;
let _e6116 = (_e6115 != 0u);
let _e6120 = global_1.member.member_17.member;
let _e6140 = select(-1e6f, (((((_e6120.member.member * _e1418) + (_e6120.member.member_1 * _e1431)) + (_e6120.member.member_2 * _e1396)) + _e6120.member_1) * _e6035), _e6116);
let _e6141 = select(-1e6f, (((((_e6120.member.member * _e1441) + (_e6120.member.member_1 * _e1446)) + (_e6120.member.member_2 * _e1435)) + _e6120.member_1) * _e6035), _e6116);
let _e6146 = global_1.member.member_17.member.member;
let _e6150 = -(_e6140);
let _e6153 = (_e6140 - _e6141);
let _e6154 = (_e6141 - _e6140);
let _e6156 = select(_e6154, _e6153, (_e6153 > _e6154));
let _e6159 = (select(_e6150, _e6140, (_e6140 > _e6150)) / select(1e-30f, _e6156, (_e6156 > 1e-30f)));
let _e6163 = select(0f, select(2f, _e6159, (_e6141 < 0f)), (_e6140 > 0f));
let _e6167 = select(2f, select(0f, _e6159, (_e6140 < 0f)), (_e6141 > 0f));
let _e6168 = (_e6140 > _e6106);
let _e6172 = ((_e6163 > _e6098) || ((_e6163 == _e6098) && _e6168));
let _e6173 = (_e6167 < _e6102);
let _e6174 = select(_e6098, _e6163, _e6172);
let _e6178 = select(_e6102, _e6167, _e6173);
let _e6182 = select(_e6106, _e6140, _e6168);
let _e6184 = select(_e6108, _e6141, (_e6141 > _e6108));
let _e6191 = global_1.member.member_18.member_1;
let _e6192 = (_e6191 != 0u);
let _e6196 = global_1.member.member_18.member;
let _e6216 = select(-1e6f, (((((_e6196.member.member * _e1418) + (_e6196.member.member_1 * _e1431)) + (_e6196.member.member_2 * _e1396)) + _e6196.member_1) * _e6035), _e6192);
let _e6217 = select(-1e6f, (((((_e6196.member.member * _e1441) + (_e6196.member.member_1 * _e1446)) + (_e6196.member.member_2 * _e1435)) + _e6196.member_1) * _e6035), _e6192);
let _e6222 = global_1.member.member_18.member.member;
let _e6226 = -(_e6216);
let _e6229 = (_e6216 - _e6217);
let _e6230 = (_e6217 - _e6216);
let _e6232 = select(_e6230, _e6229, (_e6229 > _e6230));
let _e6235 = (select(_e6226, _e6216, (_e6216 > _e6226)) / select(1e-30f, _e6232, (_e6232 > 1e-30f)));
let _e6239 = select(0f, select(2f, _e6235, (_e6217 < 0f)), (_e6216 > 0f));
let _e6243 = select(2f, select(0f, _e6235, (_e6216 < 0f)), (_e6217 > 0f));
let _e6244 = (_e6216 > _e6182);
let _e6248 = ((_e6239 > _e6174) || ((_e6239 == _e6174) && _e6244));
let _e6249 = (_e6243 < _e6178);
let _e6250 = select(_e6174, _e6239, _e6248);
let _e6254 = select(_e6178, _e6243, _e6249);
let _e6258 = select(_e6182, _e6216, _e6244);
let _e6260 = select(_e6184, _e6217, (_e6217 > _e6184));
let _e6267 = global_1.member.member_19.member_1;
let _e6268 = (_e6267 != 0u);
let _e6272 = global_1.member.member_19.member;
let _e6292 = select(-1e6f, (((((_e6272.member.member * _e1418) + (_e6272.member.member_1 * _e1431)) + (_e6272.member.member_2 * _e1396)) + _e6272.member_1) * _e6035), _e6268);
let _e6293 = select(-1e6f, (((((_e6272.member.member * _e1441) + (_e6272.member.member_1 * _e1446)) + (_e6272.member.member_2 * _e1435)) + _e6272.member_1) * _e6035), _e6268);
let _e6298 = global_1.member.member_19.member.member;
let _e6302 = -(_e6292);
let _e6305 = (_e6292 - _e6293);
let _e6306 = (_e6293 - _e6292);
let _e6308 = select(_e6306, _e6305, (_e6305 > _e6306));
let _e6311 = (select(_e6302, _e6292, (_e6292 > _e6302)) / select(1e-30f, _e6308, (_e6308 > 1e-30f)));
let _e6315 = select(0f, select(2f, _e6311, (_e6293 < 0f)), (_e6292 > 0f));
let _e6319 = select(2f, select(0f, _e6311, (_e6292 < 0f)), (_e6293 > 0f));
let _e6320 = (_e6292 > _e6258);
let _e6324 = ((_e6315 > _e6250) || ((_e6315 == _e6250) && _e6320));
let _e6325 = (_e6319 < _e6254);
phi_15137_ = type_34(select(_e6250, _e6315, _e6324), vec3<f32>(select(select(select(select(_e6011, _e6070.member, _e6096), _e6146.member, _e6172), _e6222.member, _e6248), _e6298.member, _e6324), select(select(select(select(_e6012, _e6070.member_1, _e6096), _e6146.member_1, _e6172), _e6222.member_1, _e6248), _e6298.member_1, _e6324), select(select(select(select(_e6013, _e6070.member_2, _e6096), _e6146.member_2, _e6172), _e6222.member_2, _e6248), _e6298.member_2, _e6324)), select(_e6254, _e6319, _e6325), vec3<f32>(select(select(select(select(_e6016, _e6070.member, _e6097), _e6146.member, _e6173), _e6222.member, _e6249), _e6298.member, _e6325), select(select(select(select(_e6017, _e6070.member_1, _e6097), _e6146.member_1, _e6173), _e6222.member_1, _e6249), _e6298.member_1, _e6325), select(select(select(select(_e6018, _e6070.member_2, _e6097), _e6146.member_2, _e6173), _e6222.member_2, _e6249), _e6298.member_2, _e6325)), select(_e6258, _e6292, _e6320), select(_e6260, _e6293, (_e6293 > _e6260)), vec3<f32>(select(select(select(select(_e6023, _e6070.member, _e6092), _e6146.member, _e6168), _e6222.member, _e6244), _e6298.member, _e6320), select(select(select(select(_e6024, _e6070.member_1, _e6092), _e6146.member_1, _e6168), _e6222.member_1, _e6244), _e6298.member_1, _e6320), select(select(select(select(_e6025, _e6070.member_2, _e6092), _e6146.member_2, _e6168), _e6222.member_2, _e6244), _e6298.member_2, _e6320)));
}
let _e6345 = phi_15137_;
let _e6347 = (_e6345.member_4 < 0f);
let _e6349 = (_e6345.member_5 < 0f);
let _e6350 = (_e6347 != _e6349);
if _e6347 {
phi_15150_ = _e6345.member_3;
phi_15151_ = _e6345.member_2;
} else {
phi_15150_ = _e6345.member_1;
phi_15151_ = _e6345.member;
}
let _e6356 = phi_15150_;
let _e6358 = phi_15151_;
let _e6367 = (((_e5746.member * _e5746.member) + (_e5746.member_1 * _e5746.member_1)) + (_e5746.member_2 * _e5746.member_2));
let _e6370 = sqrt(select(0f, _e6367, (_e6367 > 0f)));
let _e6371 = ((1.5f * _e1416) * _e6370);
let _e6376 = select(0f, _e6358, _e6350);
let _e6380 = (_e1418 + (_e4246 * _e6376));
let _e6381 = (_e1431 + (_e4247 * _e6376));
let _e6382 = (_e1396 + (_e4248 * _e6376));
let _e6388 = ((((_e1513.member.member * _e6380) + (_e1513.member.member_1 * _e6381)) + (_e1513.member.member_2 * _e6382)) + _e1513.member_1);
let _e6394 = ((((_e1528.member.member * _e6380) + (_e1528.member.member_1 * _e6381)) + (_e1528.member.member_2 * _e6382)) + _e1528.member_1);
let _e6400 = ((((_e1543.member.member * _e6380) + (_e1543.member.member_1 * _e6381)) + (_e1543.member.member_2 * _e6382)) + _e1543.member_1);
let _e6402 = select(-0.5f, _e6388, (_e6388 > -0.5f));
let _e6404 = select(_e5771, _e6402, (_e6402 < _e5771));
let _e6406 = select(-0.5f, _e6394, (_e6394 > -0.5f));
let _e6408 = select(_e5857, _e6406, (_e6406 < _e5857));
let _e6410 = select(-0.5f, _e6400, (_e6400 > -0.5f));
let _e6412 = select(_e5943, _e6410, (_e6410 < _e5943));
let _e6414 = select(-1f, _e6404, (_e6404 > -1f));
let _e6416 = select(_e5770, _e6414, (_e6414 < _e5770));
let _e6423 = select(0i, select(select(i32(_e6416), i32(-2147483648), (_e6416 < -2147483600f)), 2147483647i, (_e6416 > 2147483500f)), (_e6416 == _e6416));
let _e6427 = (_e6423 - select(0i, 1i, (_e6416 < f32(_e6423))));
let _e6429 = select(-1f, _e6408, (_e6408 > -1f));
let _e6431 = select(_e5856, _e6429, (_e6429 < _e5856));
let _e6438 = select(0i, select(select(i32(_e6431), i32(-2147483648), (_e6431 < -2147483600f)), 2147483647i, (_e6431 > 2147483500f)), (_e6431 == _e6431));
let _e6442 = (_e6438 - select(0i, 1i, (_e6431 < f32(_e6438))));
let _e6444 = select(-1f, _e6412, (_e6412 > -1f));
let _e6446 = select(_e5942, _e6444, (_e6444 < _e5942));
let _e6453 = select(0i, select(select(i32(_e6446), i32(-2147483648), (_e6446 < -2147483600f)), 2147483647i, (_e6446 > 2147483500f)), (_e6446 == _e6446));
let _e6457 = (_e6453 - select(0i, 1i, (_e6446 < f32(_e6453))));
let _e6461 = global_1.member.member_9.member_7;
let _e6465 = global_1.member.member_9.member_8;
let _e6473 = (select(0i, select(select(i32(_e5856), i32(-2147483648), (_e5856 < -2147483600f)), 2147483647i, (_e5856 > 2147483500f)), (_e5856 == _e5856)) - 1i);
let _e6476 = (_e6442 + 1i);
let _e6486 = (select(0i, select(select(i32(_e5942), i32(-2147483648), (_e5942 < -2147483600f)), 2147483647i, (_e5942 > 2147483500f)), (_e5942 == _e5942)) - 1i);
let _e6489 = (_e6457 + 1i);
let _e6499 = (select(0i, select(select(i32(_e5770), i32(-2147483648), (_e5770 < -2147483600f)), 2147483647i, (_e5770 > 2147483500f)), (_e5770 == _e5770)) - 1i);
let _e6500 = (_e6427 - 1i);
let _e6505 = (_e6427 + 1i);
let _e6508 = (_e6427 + 2i);
let _e6511 = (select(0i, _e6442, (_e6442 > 0i)) * _e6461);
let _e6512 = (select(_e6473, _e6476, (_e6476 < _e6473)) * _e6461);
let _e6513 = (select(0i, _e6457, (_e6457 > 0i)) * _e6465);
let _e6514 = (select(_e6486, _e6489, (_e6489 < _e6486)) * _e6465);
local_2 = type_29(array<i32, 4>(select(0i, _e6500, (_e6500 > 0i)), select(0i, _e6427, (_e6427 > 0i)), select(_e6499, _e6505, (_e6505 < _e6499)), select(_e6499, _e6508, (_e6508 < _e6499))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e6404 - f32(_e6427)), (_e6408 - f32(_e6442)), (_e6412 - f32(_e6457)));
let _e6525 = (_e6513 + _e6511);
let _e6528 = local_2.member[1u];
let _e6529 = (_e6525 + _e6528);
let _e6531 = (bitcast<i32>(_e163) - 1i);
let _e6533 = select(_e6531, _e6529, (_e6529 < _e6531));
let _e6538 = global_5.member[bitcast<u32>(select(0i, _e6533, (_e6533 > 0i)))];
let _e6539 = bitcast<f32>(_e6538);
let _e6542 = local_2.member[2u];
let _e6543 = (_e6525 + _e6542);
let _e6545 = select(_e6531, _e6543, (_e6543 < _e6531));
let _e6550 = global_5.member[bitcast<u32>(select(0i, _e6545, (_e6545 > 0i)))];
let _e6552 = local_3[0u];
let _e6555 = (_e6539 + ((bitcast<f32>(_e6550) - _e6539) * _e6552));
let _e6556 = (_e6513 + _e6512);
let _e6557 = local_2.member[1u];
let _e6558 = (_e6556 + _e6557);
let _e6560 = select(_e6531, _e6558, (_e6558 < _e6531));
let _e6565 = global_5.member[bitcast<u32>(select(0i, _e6560, (_e6560 > 0i)))];
let _e6566 = bitcast<f32>(_e6565);
let _e6567 = local_2.member[2u];
let _e6568 = (_e6556 + _e6567);
let _e6570 = select(_e6531, _e6568, (_e6568 < _e6531));
let _e6575 = global_5.member[bitcast<u32>(select(0i, _e6570, (_e6570 > 0i)))];
let _e6577 = local_3[0u];
let _e6582 = local_3[1u];
let _e6585 = (_e6555 + (((_e6566 + ((bitcast<f32>(_e6575) - _e6566) * _e6577)) - _e6555) * _e6582));
let _e6586 = (_e6514 + _e6511);
let _e6587 = local_2.member[1u];
let _e6588 = (_e6586 + _e6587);
let _e6590 = select(_e6531, _e6588, (_e6588 < _e6531));
let _e6595 = global_5.member[bitcast<u32>(select(0i, _e6590, (_e6590 > 0i)))];
let _e6596 = bitcast<f32>(_e6595);
let _e6597 = local_2.member[2u];
let _e6598 = (_e6586 + _e6597);
let _e6600 = select(_e6531, _e6598, (_e6598 < _e6531));
let _e6605 = global_5.member[bitcast<u32>(select(0i, _e6600, (_e6600 > 0i)))];
let _e6607 = local_3[0u];
let _e6610 = (_e6596 + ((bitcast<f32>(_e6605) - _e6596) * _e6607));
let _e6611 = (_e6514 + _e6512);
let _e6612 = local_2.member[1u];
let _e6613 = (_e6611 + _e6612);
let _e6615 = select(_e6531, _e6613, (_e6613 < _e6531));
let _e6620 = global_5.member[bitcast<u32>(select(0i, _e6615, (_e6615 > 0i)))];
let _e6621 = bitcast<f32>(_e6620);
let _e6622 = local_2.member[2u];
let _e6623 = (_e6611 + _e6622);
let _e6625 = select(_e6531, _e6623, (_e6623 < _e6531));
let _e6630 = global_5.member[bitcast<u32>(select(0i, _e6625, (_e6625 > 0i)))];
let _e6632 = local_3[0u];
let _e6636 = local_3[1u];
let _e6641 = local_3[2u];
let _e6648 = global_1.member.member_9.member_6;
let _e6652 = global_1.member.member_9.member_5;
let _e6654 = (((_e6585 + (((_e6610 + (((_e6621 + ((bitcast<f32>(_e6630) - _e6621) * _e6632)) - _e6610) * _e6636)) - _e6585) * _e6641)) - _e6648) * _e6652);
let _e6656 = select(_e3935, _e6654, (_e6654 > _e3935));
local = select(1e9f, _e6656, (_e6656 < 1e9f));
let _e6659 = local;
local_1 = _e6659;
let _e6660 = local_1;
let _e6662 = (bitcast<i32>(_e168) - 1i);
let _e6664 = select(_e6662, 263197i, (263197i < _e6662));
let _e6669 = global_3.member[bitcast<u32>(select(0i, _e6664, (_e6664 > 0i)))];
let _e6672 = select(_e6662, 263198i, (263198i < _e6662));
let _e6677 = global_3.member[bitcast<u32>(select(0i, _e6672, (_e6672 > 0i)))];
let _e6680 = select(_e6662, 263199i, (263199i < _e6662));
let _e6685 = global_3.member[bitcast<u32>(select(0i, _e6680, (_e6680 > 0i)))];
let _e6686 = bitcast<f32>(_e6685);
let _e6688 = ((_e6660 - bitcast<f32>(_e6669)) * bitcast<f32>(_e6677));
let _e6690 = select(0f, _e6688, (_e6688 > 0f));
let _e6693 = local_1;
let _e6695 = select(_e6662, 263200i, (263200i < _e6662));
let _e6700 = global_3.member[bitcast<u32>(select(0i, _e6695, (_e6695 > 0i)))];
let _e6703 = select(_e6662, 263201i, (263201i < _e6662));
let _e6708 = global_3.member[bitcast<u32>(select(0i, _e6703, (_e6703 > 0i)))];
let _e6711 = select(_e6662, 263202i, (263202i < _e6662));
let _e6716 = global_3.member[bitcast<u32>(select(0i, _e6711, (_e6711 > 0i)))];
let _e6717 = bitcast<f32>(_e6716);
let _e6719 = ((_e6693 - bitcast<f32>(_e6700)) * bitcast<f32>(_e6708));
let _e6721 = select(0f, _e6719, (_e6719 > 0f));
let _e6725 = local_1;
let _e6727 = select(_e6662, 263203i, (263203i < _e6662));
let _e6732 = global_3.member[bitcast<u32>(select(0i, _e6727, (_e6727 > 0i)))];
let _e6735 = select(_e6662, 263204i, (263204i < _e6662));
let _e6740 = global_3.member[bitcast<u32>(select(0i, _e6735, (_e6735 > 0i)))];
let _e6743 = select(_e6662, 263205i, (263205i < _e6662));
let _e6748 = global_3.member[bitcast<u32>(select(0i, _e6743, (_e6743 > 0i)))];
let _e6749 = bitcast<f32>(_e6748);
let _e6751 = ((_e6725 - bitcast<f32>(_e6732)) * bitcast<f32>(_e6740));
let _e6753 = select(0f, _e6751, (_e6751 > 0f));
let _e6756 = local_1;
let _e6758 = select(_e6662, 263206i, (263206i < _e6662));
let _e6763 = global_3.member[bitcast<u32>(select(0i, _e6758, (_e6758 > 0i)))];
let _e6766 = select(_e6662, 263207i, (263207i < _e6662));
let _e6771 = global_3.member[bitcast<u32>(select(0i, _e6766, (_e6766 > 0i)))];
let _e6774 = select(_e6662, 263208i, (263208i < _e6662));
let _e6779 = global_3.member[bitcast<u32>(select(0i, _e6774, (_e6774 > 0i)))];
let _e6780 = bitcast<f32>(_e6779);
let _e6782 = ((_e6756 - bitcast<f32>(_e6763)) * bitcast<f32>(_e6771));
let _e6784 = select(0f, _e6782, (_e6782 > 0f));
let _e6788 = ((select(_e6686, _e6690, (_e6690 < _e6686)) + select(_e6717, _e6721, (_e6721 < _e6717))) + (select(_e6749, _e6753, (_e6753 < _e6749)) + select(_e6780, _e6784, (_e6784 < _e6780))));
let _e6790 = select(0f, _e6788, (_e6788 > 0f));
let _e6792 = select(1023f, _e6790, (_e6790 < 1023f));
let _e6799 = select(0i, select(select(i32(_e6792), i32(-2147483648), (_e6792 < -2147483600f)), 2147483647i, (_e6792 > 2147483500f)), (_e6792 == _e6792));
let _e6803 = (_e6799 - select(0i, 1i, (_e6792 < f32(_e6799))));
let _e6804 = (262147i + _e6803);
let _e6806 = select(_e6662, _e6804, (_e6804 < _e6662));
let _e6812 = global_3.member[bitcast<u32>(select(0i, _e6806, (_e6806 > 0i)))];
let _e6822 = select(_e6662, 262146i, (262146i < _e6662));
let _e6828 = global_3.member[bitcast<u32>(select(0i, _e6822, (_e6822 > 0i)))];
let _e6832 = select(_e6662, 262144i, (262144i < _e6662));
let _e6838 = global_3.member[bitcast<u32>(select(0i, _e6832, (_e6832 > 0i)))];
let _e6841 = select(_e6662, 262145i, (262145i < _e6662));
let _e6847 = global_3.member[bitcast<u32>(select(0i, _e6841, (_e6841 > 0i)))];
let _e6854 = ((bitcast<f32>(_e6838) + (f32(bitcast<i32>((_e6812 >> bitcast<u32>(12u)))) * bitcast<f32>(_e6847))) + ((f32((bitcast<i32>((_e6812 & 4095u)) - 2048i)) * bitcast<f32>(_e6828)) * (_e6788 - f32(_e6803))));
let _e6858 = select(_e6345.member_6.x, _e6356.x, _e6350);
let _e6861 = select(_e6345.member_6.y, _e6356.y, _e6350);
let _e6864 = select(_e6345.member_6.z, _e6356.z, _e6350);
let _e6865 = select(1f, _e6854, _e6349);
let _e6870 = (((_e6858 * _e6858) + (_e6861 * _e6861)) + (_e6864 * _e6864));
let _e6873 = sqrt(select(0f, _e6870, (_e6870 > 0f)));
let _e6876 = (1f / select(1e-20f, _e6873, (_e6873 > 1e-20f)));
let _e6877 = (_e6858 * _e6876);
let _e6878 = (_e6861 * _e6876);
let _e6879 = (_e6864 * _e6876);
let _e6884 = (((_e236 * _e6877) + (_e247 * _e6878)) + (_e258 * _e6879));
let _e6889 = (((_e236 * _e236) + (_e247 * _e247)) + (_e258 * _e258));
let _e6891 = ((_e6865 * _e6865) - _e6889);
let _e6892 = (_e6884 * _e6884);
let _e6893 = (_e6892 + _e6891);
let _e6896 = sqrt(select(0f, _e6893, (_e6893 > 0f)));
let _e6900 = (_e6893 <= 0f);
let _e6903 = select((select(_e6896, -(_e6896), (_e6884 < 0f)) - _e6884), (-2f * _e6884), _e6900);
let _e6904 = (_e6891 == 0f);
let _e6915 = (_e6900 && (_e6891 != 0f));
let _e6921 = (!(_e6350) && (_e6915 || (_e6892 < ((0.1f * 0.1f) * _e6889))));
let _e6923 = select(1e-12f, _e6889, (_e6889 > 1e-12f));
let _e6927 = (_e6865 / sqrt(select(0f, _e6923, (_e6923 > 0f))));
let _e6939 = ((_e6350 || (bitcast<f32>((bitcast<u32>(_e6345.member_4) & 2147483647u)) < select(1f, _e6371, (_e6371 < 1f)))) && (_e6854 != 1f));
let _e6940 = select(_e236, select(select(select((_e236 + (_e6877 * _e6903)), _e236, _e6904), _e236, _e6915), (_e236 * _e6927), _e6921), _e6939);
let _e6941 = select(_e247, select(select(select((_e247 + (_e6878 * _e6903)), _e247, _e6904), _e247, _e6915), (_e247 * _e6927), _e6921), _e6939);
let _e6942 = select(_e258, select(select(select((_e258 + (_e6879 * _e6903)), _e258, _e6904), _e258, _e6915), (_e258 * _e6927), _e6921), _e6939);
let _e6954 = global_1.member.member_7.member_2;
let _e6957 = (_e6954 / select(1e-6f, _e6942, (_e6942 > 1e-6f)));
let _e6961 = (_e1441 + (_e6940 * _e6957));
let _e6962 = (_e1446 + (_e6941 * _e6957));
let _e6963 = (_e1435 + (_e6942 * _e6957));
let _e6969 = ((((_e1513.member.member * _e6961) + (_e1513.member.member_1 * _e6962)) + (_e1513.member.member_2 * _e6963)) + _e1513.member_1);
let _e6975 = ((((_e1528.member.member * _e6961) + (_e1528.member.member_1 * _e6962)) + (_e1528.member.member_2 * _e6963)) + _e1528.member_1);
let _e6981 = ((((_e1543.member.member * _e6961) + (_e1543.member.member_1 * _e6962)) + (_e1543.member.member_2 * _e6963)) + _e1543.member_1);
let _e6982 = (-0.5f - _e6969);
let _e6983 = -(_e5773);
let _e6986 = (_e5773 - _e6982);
let _e6987 = (_e6982 - _e5773);
let _e6989 = select(_e6987, _e6986, (_e6986 > _e6987));
let _e6992 = (select(_e6983, _e5773, (_e5773 > _e6983)) / select(1e-30f, _e6989, (_e6989 > 1e-30f)));
let _e6995 = select(0f, select(2f, _e6992, (_e6982 < 0f)), _e5788);
let _e6998 = select(2f, select(0f, _e6992, _e5785), (_e6982 > 0f));
let _e7002 = ((_e6995 > -1f) || ((_e6995 == -1f) && _e5807));
let _e7003 = (_e6998 < 2f);
let _e7004 = select(-1f, _e6995, _e7002);
let _e7008 = select(2f, _e6998, _e7003);
let _e7013 = select(-1e30f, _e6982, (_e6982 > -1e30f));
let _e7017 = (_e6969 - _e5771);
let _e7018 = -(_e5813);
let _e7021 = (_e5813 - _e7017);
let _e7022 = (_e7017 - _e5813);
let _e7024 = select(_e7022, _e7021, (_e7021 > _e7022));
let _e7027 = (select(_e7018, _e5813, (_e5813 > _e7018)) / select(1e-30f, _e7024, (_e7024 > 1e-30f)));
let _e7030 = select(0f, select(2f, _e7027, (_e7017 < 0f)), _e5828);
let _e7033 = select(2f, select(0f, _e7027, _e5825), (_e7017 > 0f));
let _e7037 = ((_e7030 > _e7004) || ((_e7030 == _e7004) && _e5847));
let _e7038 = (_e7033 < _e7008);
let _e7039 = select(_e7004, _e7030, _e7037);
let _e7043 = select(_e7008, _e7033, _e7038);
let _e7048 = select(_e7013, _e7017, (_e7017 > _e7013));
let _e7052 = (-0.5f - _e6975);
let _e7053 = -(_e5859);
let _e7056 = (_e5859 - _e7052);
let _e7057 = (_e7052 - _e5859);
let _e7059 = select(_e7057, _e7056, (_e7056 > _e7057));
let _e7062 = (select(_e7053, _e5859, (_e5859 > _e7053)) / select(1e-30f, _e7059, (_e7059 > 1e-30f)));
let _e7065 = select(0f, select(2f, _e7062, (_e7052 < 0f)), _e5874);
let _e7068 = select(2f, select(0f, _e7062, _e5871), (_e7052 > 0f));
let _e7072 = ((_e7065 > _e7039) || ((_e7065 == _e7039) && _e5893));
let _e7073 = (_e7068 < _e7043);
let _e7074 = select(_e7039, _e7065, _e7072);
let _e7078 = select(_e7043, _e7068, _e7073);
let _e7083 = select(_e7048, _e7052, (_e7052 > _e7048));
let _e7087 = (_e6975 - _e5857);
let _e7088 = -(_e5899);
let _e7091 = (_e5899 - _e7087);
let _e7092 = (_e7087 - _e5899);
let _e7094 = select(_e7092, _e7091, (_e7091 > _e7092));
let _e7097 = (select(_e7088, _e5899, (_e5899 > _e7088)) / select(1e-30f, _e7094, (_e7094 > 1e-30f)));
let _e7100 = select(0f, select(2f, _e7097, (_e7087 < 0f)), _e5914);
let _e7103 = select(2f, select(0f, _e7097, _e5911), (_e7087 > 0f));
let _e7107 = ((_e7100 > _e7074) || ((_e7100 == _e7074) && _e5933));
let _e7108 = (_e7103 < _e7078);
let _e7109 = select(_e7074, _e7100, _e7107);
let _e7113 = select(_e7078, _e7103, _e7108);
let _e7118 = select(_e7083, _e7087, (_e7087 > _e7083));
let _e7122 = (-0.5f - _e6981);
let _e7123 = -(_e5945);
let _e7126 = (_e5945 - _e7122);
let _e7127 = (_e7122 - _e5945);
let _e7129 = select(_e7127, _e7126, (_e7126 > _e7127));
let _e7132 = (select(_e7123, _e5945, (_e5945 > _e7123)) / select(1e-30f, _e7129, (_e7129 > 1e-30f)));
let _e7135 = select(0f, select(2f, _e7132, (_e7122 < 0f)), _e5960);
let _e7138 = select(2f, select(0f, _e7132, _e5957), (_e7122 > 0f));
let _e7142 = ((_e7135 > _e7109) || ((_e7135 == _e7109) && _e5979));
let _e7143 = (_e7138 < _e7113);
let _e7144 = select(_e7109, _e7135, _e7142);
let _e7148 = select(_e7113, _e7138, _e7143);
let _e7153 = select(_e7118, _e7122, (_e7122 > _e7118));
let _e7157 = (_e6981 - _e5943);
let _e7158 = -(_e5985);
let _e7161 = (_e5985 - _e7157);
let _e7162 = (_e7157 - _e5985);
let _e7164 = select(_e7162, _e7161, (_e7161 > _e7162));
let _e7167 = (select(_e7158, _e5985, (_e5985 > _e7158)) / select(1e-30f, _e7164, (_e7164 > 1e-30f)));
let _e7170 = select(0f, select(2f, _e7167, (_e7157 < 0f)), _e6000);
let _e7173 = select(2f, select(0f, _e7167, _e5997), (_e7157 > 0f));
let _e7177 = ((_e7170 > _e7144) || ((_e7170 == _e7144) && _e6021));
let _e7178 = (_e7173 < _e7148);
let _e7179 = select(_e7144, _e7170, _e7177);
let _e7180 = select(select(select(select(select(select(0f, _e5746.member, _e7002), _e5746.member, _e7037), _e5754.member, _e7072), _e5754.member, _e7107), _e5762.member, _e7142), _e5762.member, _e7177);
let _e7181 = select(select(select(select(select(select(0f, _e5746.member_1, _e7002), _e5746.member_1, _e7037), _e5754.member_1, _e7072), _e5754.member_1, _e7107), _e5762.member_1, _e7142), _e5762.member_1, _e7177);
let _e7182 = select(select(select(select(select(select(1f, _e5746.member_2, _e7002), _e5746.member_2, _e7037), _e5754.member_2, _e7072), _e5754.member_2, _e7107), _e5762.member_2, _e7142), _e5762.member_2, _e7177);
let _e7184 = select(_e7148, _e7173, _e7178);
let _e7185 = select(select(select(select(select(select(0f, _e5746.member, _e7003), _e5746.member, _e7038), _e5754.member, _e7073), _e5754.member, _e7108), _e5762.member, _e7143), _e5762.member, _e7178);
let _e7186 = select(select(select(select(select(select(0f, _e5746.member_1, _e7003), _e5746.member_1, _e7038), _e5754.member_1, _e7073), _e5754.member_1, _e7108), _e5762.member_1, _e7143), _e5762.member_1, _e7178);
let _e7187 = select(select(select(select(select(select(1f, _e5746.member_2, _e7003), _e5746.member_2, _e7038), _e5754.member_2, _e7073), _e5754.member_2, _e7108), _e5762.member_2, _e7143), _e5762.member_2, _e7178);
let _e7190 = select(_e7153, _e7157, (_e7157 > _e7153));
let _e7191 = select(select(select(select(select(select(0f, _e5746.member, _e5807), _e5746.member, _e5847), _e5754.member, _e5893), _e5754.member, _e5933), _e5762.member, _e5979), _e5762.member, _e6021);
let _e7192 = select(select(select(select(select(select(0f, _e5746.member_1, _e5807), _e5746.member_1, _e5847), _e5754.member_1, _e5893), _e5754.member_1, _e5933), _e5762.member_1, _e5979), _e5762.member_1, _e6021);
let _e7193 = select(select(select(select(select(select(1f, _e5746.member_2, _e5807), _e5746.member_2, _e5847), _e5754.member_2, _e5893), _e5754.member_2, _e5933), _e5762.member_2, _e5979), _e5762.member_2, _e6021);
if _e3944 {
phi_17767_ = type_34(_e7179, vec3<f32>(_e7180, _e7181, _e7182), _e7184, vec3<f32>(_e7185, _e7186, _e7187), _e6022, _e7190, vec3<f32>(_e7191, _e7192, _e7193));
} else {
let _e7199 = global_1.member.member_16.member_1;
let _e7200 = (_e7199 != 0u);
let _e7204 = global_1.member.member_16.member;
let _e7224 = select(-1e6f, (((((_e7204.member.member * _e1441) + (_e7204.member.member_1 * _e1446)) + (_e7204.member.member_2 * _e1435)) + _e7204.member_1) * _e6370), _e7200);
let _e7225 = select(-1e6f, (((((_e7204.member.member * _e6961) + (_e7204.member.member_1 * _e6962)) + (_e7204.member.member_2 * _e6963)) + _e7204.member_1) * _e6370), _e7200);
let _e7230 = global_1.member.member_16.member.member;
let _e7234 = -(_e7224);
let _e7237 = (_e7224 - _e7225);
let _e7238 = (_e7225 - _e7224);
let _e7240 = select(_e7238, _e7237, (_e7237 > _e7238));
let _e7243 = (select(_e7234, _e7224, (_e7224 > _e7234)) / select(1e-30f, _e7240, (_e7240 > 1e-30f)));
let _e7247 = select(0f, select(2f, _e7243, (_e7225 < 0f)), (_e7224 > 0f));
let _e7251 = select(2f, select(0f, _e7243, (_e7224 < 0f)), (_e7225 > 0f));
let _e7252 = (_e7224 > _e6022);
let _e7256 = ((_e7247 > _e7179) || ((_e7247 == _e7179) && _e7252));
let _e7257 = (_e7251 < _e7184);
let _e7258 = select(_e7179, _e7247, _e7256);
let _e7262 = select(_e7184, _e7251, _e7257);
let _e7266 = select(_e6022, _e7224, _e7252);
let _e7268 = select(_e7190, _e7225, (_e7225 > _e7190));
let _e7275 = global_1.member.member_17.member_1;
let _e7276 = (_e7275 != 0u);
let _e7280 = global_1.member.member_17.member;
let _e7300 = select(-1e6f, (((((_e7280.member.member * _e1441) + (_e7280.member.member_1 * _e1446)) + (_e7280.member.member_2 * _e1435)) + _e7280.member_1) * _e6370), _e7276);
let _e7301 = select(-1e6f, (((((_e7280.member.member * _e6961) + (_e7280.member.member_1 * _e6962)) + (_e7280.member.member_2 * _e6963)) + _e7280.member_1) * _e6370), _e7276);
let _e7306 = global_1.member.member_17.member.member;
let _e7310 = -(_e7300);
let _e7313 = (_e7300 - _e7301);
let _e7314 = (_e7301 - _e7300);
let _e7316 = select(_e7314, _e7313, (_e7313 > _e7314));
let _e7319 = (select(_e7310, _e7300, (_e7300 > _e7310)) / select(1e-30f, _e7316, (_e7316 > 1e-30f)));
let _e7323 = select(0f, select(2f, _e7319, (_e7301 < 0f)), (_e7300 > 0f));
let _e7327 = select(2f, select(0f, _e7319, (_e7300 < 0f)), (_e7301 > 0f));
let _e7328 = (_e7300 > _e7266);
let _e7332 = ((_e7323 > _e7258) || ((_e7323 == _e7258) && _e7328));
let _e7333 = (_e7327 < _e7262);
let _e7334 = select(_e7258, _e7323, _e7332);
let _e7338 = select(_e7262, _e7327, _e7333);
let _e7342 = select(_e7266, _e7300, _e7328);
let _e7344 = select(_e7268, _e7301, (_e7301 > _e7268));
let _e7351 = global_1.member.member_18.member_1;
let _e7352 = (_e7351 != 0u);
let _e7356 = global_1.member.member_18.member;
let _e7376 = select(-1e6f, (((((_e7356.member.member * _e1441) + (_e7356.member.member_1 * _e1446)) + (_e7356.member.member_2 * _e1435)) + _e7356.member_1) * _e6370), _e7352);
let _e7377 = select(-1e6f, (((((_e7356.member.member * _e6961) + (_e7356.member.member_1 * _e6962)) + (_e7356.member.member_2 * _e6963)) + _e7356.member_1) * _e6370), _e7352);
let _e7382 = global_1.member.member_18.member.member;
let _e7386 = -(_e7376);
let _e7389 = (_e7376 - _e7377);
let _e7390 = (_e7377 - _e7376);
let _e7392 = select(_e7390, _e7389, (_e7389 > _e7390));
let _e7395 = (select(_e7386, _e7376, (_e7376 > _e7386)) / select(1e-30f, _e7392, (_e7392 > 1e-30f)));
let _e7399 = select(0f, select(2f, _e7395, (_e7377 < 0f)), (_e7376 > 0f));
let _e7403 = select(2f, select(0f, _e7395, (_e7376 < 0f)), (_e7377 > 0f));
let _e7404 = (_e7376 > _e7342);
let _e7408 = ((_e7399 > _e7334) || ((_e7399 == _e7334) && _e7404));
let _e7409 = (_e7403 < _e7338);
let _e7410 = select(_e7334, _e7399, _e7408);
let _e7414 = select(_e7338, _e7403, _e7409);
let _e7418 = select(_e7342, _e7376, _e7404);
let _e7420 = select(_e7344, _e7377, (_e7377 > _e7344));
let _e7427 = global_1.member.member_19.member_1;
let _e7428 = (_e7427 != 0u);
let _e7432 = global_1.member.member_19.member;
let _e7452 = select(-1e6f, (((((_e7432.member.member * _e1441) + (_e7432.member.member_1 * _e1446)) + (_e7432.member.member_2 * _e1435)) + _e7432.member_1) * _e6370), _e7428);
let _e7453 = select(-1e6f, (((((_e7432.member.member * _e6961) + (_e7432.member.member_1 * _e6962)) + (_e7432.member.member_2 * _e6963)) + _e7432.member_1) * _e6370), _e7428);
let _e7458 = global_1.member.member_19.member.member;
let _e7462 = -(_e7452);
let _e7465 = (_e7452 - _e7453);
let _e7466 = (_e7453 - _e7452);
let _e7468 = select(_e7466, _e7465, (_e7465 > _e7466));
let _e7471 = (select(_e7462, _e7452, (_e7452 > _e7462)) / select(1e-30f, _e7468, (_e7468 > 1e-30f)));
let _e7475 = select(0f, select(2f, _e7471, (_e7453 < 0f)), (_e7452 > 0f));
let _e7479 = select(2f, select(0f, _e7471, (_e7452 < 0f)), (_e7453 > 0f));
let _e7480 = (_e7452 > _e7418);
let _e7484 = ((_e7475 > _e7410) || ((_e7475 == _e7410) && _e7480));
let _e7485 = (_e7479 < _e7414);
phi_17767_ = type_34(select(_e7410, _e7475, _e7484), vec3<f32>(select(select(select(select(_e7180, _e7230.member, _e7256), _e7306.member, _e7332), _e7382.member, _e7408), _e7458.member, _e7484), select(select(select(select(_e7181, _e7230.member_1, _e7256), _e7306.member_1, _e7332), _e7382.member_1, _e7408), _e7458.member_1, _e7484), select(select(select(select(_e7182, _e7230.member_2, _e7256), _e7306.member_2, _e7332), _e7382.member_2, _e7408), _e7458.member_2, _e7484)), select(_e7414, _e7479, _e7485), vec3<f32>(select(select(select(select(_e7185, _e7230.member, _e7257), _e7306.member, _e7333), _e7382.member, _e7409), _e7458.member, _e7485), select(select(select(select(_e7186, _e7230.member_1, _e7257), _e7306.member_1, _e7333), _e7382.member_1, _e7409), _e7458.member_1, _e7485), select(select(select(select(_e7187, _e7230.member_2, _e7257), _e7306.member_2, _e7333), _e7382.member_2, _e7409), _e7458.member_2, _e7485)), select(_e7418, _e7452, _e7480), select(_e7420, _e7453, (_e7453 > _e7420)), vec3<f32>(select(select(select(select(_e7191, _e7230.member, _e7252), _e7306.member, _e7328), _e7382.member, _e7404), _e7458.member, _e7480), select(select(select(select(_e7192, _e7230.member_1, _e7252), _e7306.member_1, _e7328), _e7382.member_1, _e7404), _e7458.member_1, _e7480), select(select(select(select(_e7193, _e7230.member_2, _e7252), _e7306.member_2, _e7328), _e7382.member_2, _e7404), _e7458.member_2, _e7480)));
}
let _e7505 = phi_17767_;
let _e7514 = global_1.member.member_7.member_4;
let _e7517 = (_e3662.member_3.x * _e4147.member_2);
let _e7519 = (_e3662.member_3.y * _e4147.member_2);
let _e7521 = (_e3662.member_3.z * _e4147.member_2);
let _e7522 = (0.5f * (_e6957 * select(1f, (2f * (1f - _e6358)), (_e6350 && _e6349))));
let _e7526 = (_e6940 + (_e7517 * _e7522));
let _e7527 = (_e6941 + (_e7519 * _e7522));
let _e7528 = (_e6942 + (_e7521 * _e7522));
let _e7530 = (2f * _e6954);
let _e7532 = ((_e7528 * _e7528) + (_e7530 * _e7521));
let _e7536 = (_e7528 + sqrt(select(0f, _e7532, (_e7532 > 0f))));
let _e7540 = (select(0.5f, _e7505.member_2, (_e7505.member_2 < 1f)) * (_e7530 / select(1e-6f, _e7536, (_e7536 > 1e-6f))));
let _e7544 = (_e7526 + (_e7517 * _e7540));
let _e7545 = (_e7527 + (_e7519 * _e7540));
let _e7546 = (_e7528 + (_e7521 * _e7540));
let _e7550 = (_e7514 * _e7514);
let _e7552 = (_e7546 * _e7546);
let _e7560 = (((_e7528 <= 0f) || (_e7532 <= 0f)) || ((_e7546 <= 0f) || (_e7552 <= (_e7550 * (((_e7544 * _e7544) + (_e7545 * _e7545)) + _e7552)))));
let _e7574 = (_e6940 + ((_e3662.member_4.x * _e4147.member_2) * _e6954));
let _e7575 = (_e6941 + ((_e3662.member_4.y * _e4147.member_2) * _e6954));
let _e7576 = (_e6942 + ((_e3662.member_4.z * _e4147.member_2) * _e6954));
let _e7578 = (_e7576 * _e7576);
let _e7587 = ((_e3942 & 1u) != 0u);
let _e7592 = (select(_e7560, ((_e7576 <= 0f) || (_e7578 <= (_e7550 * (((_e7574 * _e7574) + (_e7575 * _e7575)) + _e7578)))), _e7587) || (_e6939 && ((_e6915 && _e6350) || (_e6350 && (_e6942 <= 0f)))));
phi_17919_ = vec3<f32>(select(select(select(_e7544, _e7526, _e7560), _e7574, _e7587), _e236, _e7592), select(select(select(_e7545, _e7527, _e7560), _e7575, _e7587), _e247, _e7592), select(select(select(_e7546, _e7528, _e7560), _e7576, _e7587), _e258, _e7592));
phi_17920_ = select(1f, 0f, _e7592);
} else {
phi_17919_ = vec3<f32>(_e236, _e247, _e258);
phi_17920_ = 1f;
}
let _e7599 = phi_17919_;
let _e7601 = phi_17920_;
let _e7604 = (_e5723.member * _e7601);
global_4.member[_e193] = (_e204 * (_e5723.member_2.x * _e7604));
global_4.member[_e205] = (_e214 * (_e5723.member_2.y * _e7604));
global_4.member[_e216] = (_e225 * (_e5723.member_2.z * _e7604));
global_4.member[_e227] = _e7599.x;
global_4.member[_e238] = _e7599.y;
global_4.member[_e249] = _e7599.z;
global_4.member[_e260] = _e269;
global_4.member[_e271] = _e280;
global_4.member[_e282] = _e291;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
